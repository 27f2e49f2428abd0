// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A programme of a specimen of grains: how the specimen is made, and what is done to it, SI. How it
// is written is in docs/how-to/grains.md; how it is read, grain_programme_reader.hpp; what carries
// it out, grain_run.hpp.
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/grains/engine/calming.hpp"
#include "sim/grains/paths/grain_path.hpp"
#include "sim/grains/probes/grain_probe.hpp"
#include "sim/grains/probes/perturbation.hpp"
#include "sim/grains/specimens/assembly.hpp"
#include "sim/grains/specimens/grading.hpp"
#include "sim/grains/specimens/porosity_search.hpp"

namespace triax::lab {

/// Where the grains come from: a file of a state, a packing, or a cloud that is compressed.
struct GrainSource {
  std::string state_file;    ///< empty: not from there
  std::string packing_file;  ///< grain_packing.hpp; empty: not from there
  int packing_axis = 2;      ///< of the packing, 0 to 2, that becomes axis 1
  bool made() const { return state_file.empty() && packing_file.empty(); }
  int grains = 10000;
  std::uint64_t seed = 1;
  sim::GradingCurve grading = sim::paper_grading();
  sim::Compaction compaction;
  std::optional<sim::PorositySearch> search;  ///< wanted porosity; empty: friction of `compaction`
};

/// isotropic, drained, undrained (a strain path with R = 1), strain_path
struct GrainPathStage {
  sim::GrainPath path;
  std::vector<std::string> mark_names;  ///< as path.marks
  int snapshots = 0;                    ///< pictures along it, as VTK files
  bool lammps = false;                  ///< the stage is written for LAMMPS too
};
/// The stresses are held (rest), or the walls where `strain_held` (equilibrium), until the specimen
/// is at rest, which is then calmed.
struct GrainRestStage {
  bool strain_held = false;
  /// Of a rest: what is held; empty: what the servo's goal is, or what the walls carry.
  std::optional<double> axial_stress_pa, radial_stress_pa;
  double ratio = 1;  ///< R of the σ₁ − σ₃/R that is told at the end
  sim::Settling settling;
};
struct GrainProbeStage {
  sim::GrainProbing probing;
  int directions = 36;
};
struct GrainPerturbationStage {
  sim::Perturbation perturbation;
};

/// `from` of a stage that starts from the specimen itself.
inline constexpr const char* kAsMade = "specimen";

struct GrainStage {
  std::string name;    ///< unique among stages and marks
  std::string action;  ///< as the programme has it
  std::string from;    ///< stage or mark whose state it starts from, or kAsMade
  std::variant<GrainPathStage, GrainRestStage, GrainProbeStage, GrainPerturbationStage> work;
  bool save = false;  ///< its last state is kept in a file
  std::int64_t line = 0;
};

struct GrainProgramme {
  std::string name;
  std::string source;              ///< file it was read from
  std::string text;                ///< what that file holds
  std::string settings;            ///< KEY=VALUE of what was put in its place, a line each
  std::vector<std::string> files;  ///< the programme's, and the state's
  sim::ContactLaw law;
  GrainSource grains;
  std::vector<GrainStage> stages;
};

/// A name as a part of the name of a file: letters, digits, dots and hyphens, the rest as '_'. No
/// two stages or marks of a programme share one.
std::string in_file_name(const std::string& name);

}  // namespace triax::lab

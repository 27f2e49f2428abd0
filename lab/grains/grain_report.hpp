// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a run of a programme of grains came to: points, probes and measures of every stage, none of
// its states. It is what the database keeps of a run and what reports say.
//
// A database that an older version wrote does not hold all of it. What is missing is NaN, of a
// count kNotStored.
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lab/grains/grain_run.hpp"

namespace triax::lab {

inline constexpr std::int64_t kNotStored = -1;

/// The specimen that the stages begin with.
struct ReportedGrains {
  std::int64_t grains = 0;
  double smallest_m = 0, median_m = 0, largest_m = 0;  ///< diameters, by count
  sim::ContactLaw law;                                 ///< that it goes on with
  double time_step_s = 0;
  std::string state_file;                     ///< of a state or a packing; empty: made from a cloud
  std::uint64_t seed = 0;                     ///< of the cloud
  std::optional<double> compaction_friction;  ///< rad; empty: loaded
  std::optional<double> compaction_pressure;  ///< Pa
  std::optional<double> porosity_wanted;      ///< that was asked for
  int trials = 0;
  sim::GrainMeasures measures;
};

/// A state kept on the way of a path; empty where it was never reached.
struct ReportedGrainMark {
  std::string name;
  std::optional<sim::GrainPathPoint> at;  ///< strains and time since the start of the path
};

/// Of `path` how it was asked for: kind, ratio, rates and samples; 0 samples are not stored.
struct ReportedGrainPath {
  sim::GrainPath path;
  sim::GrainPathEnd end = sim::GrainPathEnd::stopped;
  std::vector<sim::GrainPathPoint> points;
  std::vector<ReportedGrainMark> marks;
  bool marks_stored = true;
};

struct ReportedGrainRest {
  bool strain_held = false;
  GrainRest rest;
};

struct ReportedGrainRose {
  sim::ProbeKind kind = sim::ProbeKind::stress;
  double norm_pa = 0;      ///< of stress probes, else 0
  double norm_strain = 0;  ///< of strain probes, else 0
  GrainRose made;
  bool parts_stored = true;  ///< false: the microscopic work is one sum, all of it as normal part

  double norm() const { return kind == sim::ProbeKind::stress ? norm_pa : norm_strain; }
};

/// Of `how` what was done: ratio, load step, energy, share and seed.
struct ReportedPerturbation {
  sim::Perturbation how;
  sim::PerturbationEnd end = sim::PerturbationEnd::undecided;
  std::vector<sim::PerturbationPoint> points;
  std::int64_t grains_hit = 0;
  double most_kinetic_j = 0;
  bool seed_stored = true;
};

struct ReportedGrainStage {
  std::string name, action, from;
  sim::GrainMeasures before, after;
  sim::AxisymmetricStrain strain_before;  ///< of the start since the specimen was made
  double seconds = 0;                     ///< 0: not known
  std::int64_t steps = 0;
  std::optional<sim::GrainLedger> ledger;  ///< empty of a rose, and where it is not stored
  std::variant<ReportedGrainPath, ReportedGrainRest, ReportedGrainRose, ReportedPerturbation> came;
};

struct GrainReport {
  std::string programme, source;
  std::optional<ReportedGrains> specimen;
  std::vector<ReportedGrainStage> stages;

  /// "dense, 10000 grains, n = 0.3864": what pictures say of where they come from.
  std::string about() const;
};

/// Of the specimen when it is there.
ReportedGrains reported(const GrainSource& asked, const GrainsMade& made);
/// Of a stage that ended. Pre-condition: result.stage is not null and its work is what the outcome
/// is of.
ReportedGrainStage reported(const GrainStageResult& result);

/// A ledger of which nothing is stored.
sim::GrainLedger ledger_not_stored();
/// Measures of which nothing is stored.
sim::GrainMeasures measures_not_stored();

}  // namespace triax::lab

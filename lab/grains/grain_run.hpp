// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Carries a programme of grains out: stages one after the other, each from the state that it names.
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lab/grains/grain_programme.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/grains/state/grain_progress.hpp"

namespace triax::lab {

/// The specimen that the stages begin with.
struct GrainsMade {
  sim::GrainState state;
  sim::GrainMeasures measures;
  double compaction_friction_angle = 0;  ///< rad; 0 where it was not compacted here
  int trials = 0;                        ///< compactions made; 0 where it was not compacted here
};

struct GrainRest {
  bool at_rest = false;
  sim::Settled settling;
  double path_stress_pa = 0;  ///< σ₁ − σ₃/R at the end, with the R that the stage names
};
struct GrainRose {
  sim::AxisymmetricStress stress;  ///< that was probed, Pa
  std::vector<double> angles;      ///< rad, as rose.probes
  sim::ProbeRose rose;
};

struct GrainStageResult {
  const GrainStage* stage = nullptr;      ///< of the programme, which has to live as long
  sim::GrainMeasures before, after;       ///< a rose leaves its state alone: both are the same
  sim::AxisymmetricStrain strain_before;  ///< natural, of the start since the specimen was made
  double seconds = 0;                     ///< on the clock of the wall
  std::int64_t steps = 0;                 ///< of the engine; of all probes together
  /// Of energy and momentum over the stage; empty of a rose, whose probes have one each.
  std::optional<sim::GrainLedger> ledger;
  std::variant<sim::GrainPathResult, GrainRest, GrainRose, sim::PerturbationResult> outcome;
};

/// What a run tells, in this order. Any may be empty.
struct GrainListener {
  std::function<void(const GrainsMade&)> made;
  /// A stage begins with this state.
  std::function<void(const GrainStage&, const sim::GrainState&)> stage_started;
  /// A point of a path was kept.
  std::function<void(const GrainStage&, const sim::GrainState&, const sim::GrainPathPoint&)>
      point_kept;
  std::function<void(const GrainStage&, const sim::GrainState&, const GrainStageResult&)>
      stage_ended;
};
using GrainListeners = std::vector<GrainListener>;

struct GrainRunOptions {
  int threads = 1;
  /// Asked with the share of the stage, and what is done; false breaks the run off.
  sim::GrainProgress progress = {};
};

/// False: the progress stopped it; stages that ended before have been told. The results are the
/// same on any number of threads. Throws BadInput (a state file that cannot be read, a specimen
/// that cannot be made so), WorkFailed with the stage's name (GrainsFailed, a porosity that no
/// friction gives), and what a listener throws.
bool run_grains(const GrainProgramme& programme, const GrainRunOptions& options,
                const GrainListeners& listeners = {});

}  // namespace triax::lab

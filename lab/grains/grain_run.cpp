// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/listeners.hpp"
#include "lab/grains/grain_files.hpp"
#include "lab/grains/grain_packing.hpp"
#include "sim/grains/engine/calming.hpp"
#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/specimens/cloud.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::lab {
namespace {

sim::Compacted made_to_porosity(const GrainSource& source, const sim::Cloud& cloud,
                                const sim::ContactLaw& law, int threads,
                                const sim::GrainProgress& progress, GrainsMade& made) {
  sim::PorosityFound found =
      seek_porosity(cloud, law, source.compaction, *source.search, threads, progress);
  made.compaction_friction_angle = found.friction_angle;
  made.trials = found.trials;
  if (found.best.stopped || found.reached) return std::move(found.best);
  const std::string why =
      found.below_bracket
          ? "denser than this specimen becomes with any friction angle of compaction"
      : found.above_bracket
          ? "looser than this specimen becomes with any friction angle of compaction"
      : !found.best.calm ? "the compaction did not reach equilibrium; try a larger most_steps"
                         : fmt::format("not found in {} trials", found.trials);
  throw WorkFailed(fmt::format("porosity {:g} ± {:g} was not reached, the nearest is {:.5f}: {}",
                               source.search->porosity, source.search->tolerance,
                               found.best.porosity, why));
}

/// Few grains in a small box leave no place for the last ones: then the cloud is looser.
sim::Cloud cloud_of(const GrainSource& source) {
  const auto diameters = sim::draw_diameters(source.grading, source.grains, source.seed);
  constexpr double kUsual = 0.4, kLoosest = 0.05;
  for (double share = kUsual;; share *= 0.75) {
    try {
      return sim::make_cloud(diameters, source.seed + 1, share);
    } catch (const std::invalid_argument& error) {
      if (share < kLoosest) throw BadInput(fmt::format("[specimen]: {}", error.what()));
    }
  }
}

/// Empty: the progress stopped it.
std::optional<GrainsMade> make_specimen(const GrainProgramme& programme, int threads,
                                        const sim::GrainProgress& progress) {
  GrainsMade made;
  const GrainSource& source = programme.grains;
  if (!source.state_file.empty()) {
    made.state = load_state(source.state_file);
  } else if (!source.packing_file.empty()) {
    const GrainPacking packing = load_packing(source.packing_file, source.packing_axis);
    made.state = make_grain_state(packing.spheres, packing.box, programme.law);
  } else {
    const sim::Cloud cloud = cloud_of(source);
    sim::Compacted compacted;
    if (source.search) {
      compacted = made_to_porosity(source, cloud, programme.law, threads, progress, made);
    } else {
      compacted = compact(cloud, programme.law, source.compaction, threads, progress);
      made.compaction_friction_angle = source.compaction.friction_angle;
      made.trials = 1;
    }
    if (compacted.stopped) return std::nullopt;
    if (!compacted.calm)
      throw WorkFailed("the compaction did not reach equilibrium; try a larger most_steps");
    made.state = std::move(compacted.state);
  }
  made.measures = measure(made.state);
  return made;
}

/// What a rest holds where the programme does not say: the servo's goal, else what the walls carry.
double held_stress(const sim::GrainState& state, int axis) {
  const sim::AxisDrive& drive = state.walls.drive[axis];
  if (drive.kind == sim::AxisDrive::Kind::stress) return drive.stress_goal_pa;
  return wall_stress(state.walls, state.box, axis);
}

class Stages {
 public:
  Stages(const GrainProgramme& programme, const GrainRunOptions& options,
         const GrainListeners& listeners)
      : programme_(programme),
        threads_(options.threads),
        progress_(options.progress),
        listeners_(listeners) {
    for (std::size_t k = 0; k < programme.stages.size(); ++k)
      last_use_[programme.stages[k].from] = k;
  }

  bool run(sim::GrainState specimen) {
    made_ = specimen.box;
    keep(kAsMade, std::move(specimen), 0);
    for (std::size_t k = 0; k < programme_.stages.size(); ++k)
      if (!run(programme_.stages[k], k)) return false;
    return true;
  }

 private:
  bool run(const GrainStage& stage, std::size_t place) {
    const auto from = states_.find(stage.from);
    if (from == states_.end())
      throw WorkFailed(
          fmt::format("stage '{}': its start '{}' was never reached", stage.name, stage.from));
    const sim::GrainState start = from->second;
    notify(listeners_, &GrainListener::stage_started, stage, start);
    GrainStageResult result;
    result.stage = &stage;
    result.before = measure(start);
    result.strain_before = axisymmetric_strain(made_, start.box);
    end_ = start;
    stopped_ = false;
    const auto clock = std::chrono::steady_clock::now();
    try {
      std::visit([&](const auto& work) { result.outcome = carry_out(stage, work, start, result); },
                 stage.work);
    } catch (const sim::GrainsFailed& error) {
      throw WorkFailed(fmt::format("stage '{}': {}", stage.name, error.what()));
    } catch (const std::invalid_argument& error) {
      throw WorkFailed(fmt::format("stage '{}': {}", stage.name, error.what()));
    }
    if (stopped_) return false;
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
    result.after = measure(end_);
    if (result.steps == 0) result.steps = end_.steps - start.steps;
    notify(listeners_, &GrainListener::stage_ended, stage, end_, result);
    keep_marks(stage, result, place);
    keep(stage.name, std::move(end_), place);
    forget(place);
    return true;
  }

  sim::GrainPathResult carry_out(const GrainStage& stage, const GrainPathStage& work,
                                 const sim::GrainState& start, GrainStageResult& stage_result) {
    sim::GrainPathWatch watch;
    if (is_heard(listeners_, &GrainListener::point_kept))
      watch = [&](const sim::GrainState& state, const sim::GrainPathPoint& point) {
        notify(listeners_, &GrainListener::point_kept, stage, state, point);
      };
    sim::GrainPathResult result = follow(start, work.path, threads_, progress_, watch);
    stopped_ = result.end == sim::GrainPathEnd::stopped;
    end_ = result.state;
    stage_result.ledger = result.ledger;
    return result;
  }

  GrainRest carry_out(const GrainStage&, const GrainRestStage& work, const sim::GrainState& start,
                      GrainStageResult& stage_result) {
    GrainRest result;
    if (work.strain_held) {
      sim::Equilibrium found =
          equilibrium_at(start, work.ratio, work.settling, threads_, progress_);
      result.settling = found.rest;
      end_ = std::move(found.state);
      stage_result.ledger = found.ledger;
    } else {
      sim::AxisymmetricStress held;
      held.axial = work.axial_stress_pa.value_or(held_stress(start, sim::kAxial));
      held.radial = work.radial_stress_pa.value_or(
          0.5 * (held_stress(start, sim::kRadial[0]) + held_stress(start, sim::kRadial[1])));
      if (!(held.axial > 0) || !(held.radial > 0))
        throw std::invalid_argument(
            "the stresses to hold are not above 0: the specimen has collapsed");
      sim::Grains grains(start, threads_);
      grains.keep_ledger();
      result.settling = sim::rest(grains, held, work.settling, progress_);
      end_ = grains.state();
      stage_result.ledger = grains.ledger();
    }
    stopped_ = result.settling.stopped;
    result.at_rest = result.settling.at_rest;
    result.path_stress_pa = path_stress(axisymmetric_stress(end_), work.ratio);
    return result;
  }

  GrainRose carry_out(const GrainStage&, const GrainProbeStage& work, const sim::GrainState& start,
                      GrainStageResult& stage_result) {
    GrainRose result;
    result.stress = axisymmetric_stress(start);
    result.angles = sim::rose_angles(work.directions);
    result.rose = probe_rose(start, result.angles, work.probing, threads_, progress_);
    stopped_ = result.rose.stopped;
    stage_result.steps = result.rose.null_probe.steps;
    for (const sim::GrainProbe& probe : result.rose.probes) stage_result.steps += probe.steps;
    return result;
  }

  sim::PerturbationResult carry_out(const GrainStage&, const GrainPerturbationStage& work,
                                    const sim::GrainState& start, GrainStageResult& stage_result) {
    sim::PerturbationResult result = perturb(start, work.perturbation, threads_, progress_);
    stopped_ = result.end == sim::PerturbationEnd::stopped;
    end_ = result.state;
    stage_result.ledger = result.ledger;
    return result;
  }

  void keep_marks(const GrainStage& stage, const GrainStageResult& result, std::size_t place) {
    const auto* work = std::get_if<GrainPathStage>(&stage.work);
    if (work == nullptr) return;
    const auto& marked = std::get<sim::GrainPathResult>(result.outcome).marked;
    for (std::size_t k = 0; k < marked.size(); ++k)
      if (marked[k]) keep(work->mark_names[k], *marked[k], place);
  }
  /// States are some MB each: only those that a later stage starts from stay.
  void keep(const std::string& name, sim::GrainState state, std::size_t place) {
    const auto last = last_use_.find(name);
    if (last != last_use_.end() && (last->second > place || name == kAsMade))
      states_.insert_or_assign(name, std::move(state));
  }
  void forget(std::size_t place) {
    for (auto state = states_.begin(); state != states_.end();)
      state = last_use_[state->first] <= place ? states_.erase(state) : std::next(state);
  }

  const GrainProgramme& programme_;
  int threads_;
  const sim::GrainProgress& progress_;
  const GrainListeners& listeners_;
  sim::GrainBox made_;
  std::map<std::string, std::size_t> last_use_;
  std::map<std::string, sim::GrainState> states_;
  sim::GrainState end_;
  bool stopped_ = false;
};

}  // namespace

bool run_grains(const GrainProgramme& programme, const GrainRunOptions& options,
                const GrainListeners& listeners) {
  std::optional<GrainsMade> made;
  try {
    made = make_specimen(programme, options.threads, options.progress);
  } catch (const sim::GrainsFailed& error) {
    throw WorkFailed(fmt::format("building the specimen: {}", error.what()));
  }
  if (!made) return false;
  notify(listeners, &GrainListener::made, *made);
  return Stages(programme, options, listeners).run(std::move(made->state));
}

}  // namespace triax::lab

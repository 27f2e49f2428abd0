// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::lab {
namespace {

/// Marks are states; natural strains add up, so that the end of the path leads back to its start.
sim::GrainPathPoint since_start(const sim::GrainState& mark, const sim::GrainPathResult& result,
                                double ratio) {
  sim::GrainPathPoint at = sim::path_point(mark, result.state.box, ratio);
  const sim::GrainPathPoint& last = result.points.back();
  at.strain.axial += last.strain.axial;
  at.strain.radial += last.strain.radial;
  at.volumetric_strain = sim::volumetric_strain(at.strain);
  at.time_s = last.time_s - (result.state.time_s - mark.time_s);
  return at;
}

ReportedGrainPath reported(const GrainPathStage& stage, const sim::GrainPathResult& result) {
  ReportedGrainPath path{stage.path, result.end, result.points, {}};
  for (std::size_t k = 0; k < stage.mark_names.size(); ++k) {
    ReportedGrainMark mark{stage.mark_names[k], {}};
    if (k < result.marked.size() && result.marked[k] && !result.points.empty())
      mark.at = since_start(*result.marked[k], result, stage.path.ratio);
    path.marks.push_back(std::move(mark));
  }
  return path;
}
ReportedGrainRest reported(const GrainRestStage& stage, const GrainRest& result) {
  return {stage.strain_held, result};
}
ReportedGrainRose reported(const GrainProbeStage& stage, const GrainRose& result) {
  const sim::GrainProbing& how = stage.probing;
  const bool by_stress = how.kind == sim::ProbeKind::stress;
  return {how.kind, by_stress ? how.norm_pa : 0, by_stress ? 0 : how.norm_strain, result};
}
ReportedPerturbation reported(const GrainPerturbationStage& stage,
                              const sim::PerturbationResult& result) {
  return {stage.perturbation, result.end, result.points, result.grains_hit, result.most_kinetic_j};
}

struct Outcome {
  const GrainStage& stage;
  ReportedGrainStage& told;

  void operator()(const sim::GrainPathResult& r) { take<GrainPathStage>(r); }
  void operator()(const GrainRest& r) { take<GrainRestStage>(r); }
  void operator()(const GrainRose& r) { take<GrainProbeStage>(r); }
  void operator()(const sim::PerturbationResult& r) { take<GrainPerturbationStage>(r); }

 private:
  template <class Work, class Result>
  void take(const Result& result) {
    told.came = reported(std::get<Work>(stage.work), result);
  }
};

}  // namespace

std::string GrainReport::about() const {
  if (!specimen) return programme;
  return fmt::format("{}, {} grains, n = {:.4f}", programme, specimen->grains,
                     specimen->measures.porosity);
}

ReportedGrains reported(const GrainSource& asked, const GrainsMade& made) {
  const sim::GrainState& state = made.state;
  ReportedGrains told;
  told.grains = static_cast<std::int64_t>(state.grains.size());
  std::vector<double> diameters;
  for (const sim::Grain& grain : state.grains) diameters.push_back(2 * grain.radius);
  std::sort(diameters.begin(), diameters.end());
  if (!diameters.empty()) {
    told.smallest_m = diameters.front();
    told.median_m = diameters[(diameters.size() - 1) / 2];
    told.largest_m = diameters.back();
  }
  told.law = state.law;
  told.time_step_s = state.time_step_s;
  told.state_file = asked.state_file.empty() ? asked.packing_file : asked.state_file;
  told.measures = made.measures;
  if (!asked.made()) return told;
  told.seed = asked.seed;
  told.compaction_friction = made.compaction_friction_angle;
  told.compaction_pressure = asked.compaction.pressure_pa;
  if (asked.search) told.porosity_wanted = asked.search->porosity;
  told.trials = made.trials;
  return told;
}

ReportedGrainStage reported(const GrainStageResult& result) {
  const GrainStage& stage = *result.stage;
  ReportedGrainStage told{
      stage.name,           stage.action,   stage.from,   result.before, result.after,
      result.strain_before, result.seconds, result.steps, result.ledger, {}};
  std::visit(Outcome{stage, told}, result.outcome);
  return told;
}

sim::GrainLedger ledger_not_stored() {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  sim::GrainLedger none;
  none.walls_j = none.friction_j = none.damping_j = none.stopped_j = kNaN;
  none.elastic_start_j = none.elastic_end_j = none.kinetic_start_j = none.kinetic_end_j = kNaN;
  for (auto* impulse : {&none.walls_impulse, &none.damping_impulse, &none.stopped_impulse,
                        &none.momentum_start, &none.momentum_end})
    impulse->fill(kNaN);
  return none;
}

sim::GrainMeasures measures_not_stored() {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  sim::GrainMeasures none;
  none.kinetic_energy_j = none.unbalanced = none.void_ratio = none.porosity = none.coordination =
      kNaN;
  none.wall_stress_pa.fill(kNaN);
  none.stress_pa.setConstant(kNaN);
  none.grain_contacts = none.wall_contacts = none.sliding_contacts = none.floating_grains =
      none.grains_outside = kNotStored;
  return none;
}

}  // namespace triax::lab

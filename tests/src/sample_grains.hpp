// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A run of grains made up of results whose findings are known beforehand.
#include <cmath>
#include <numbers>

#include "db/grain_store.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::src::test {

/// ε₁ and σ₁ − σ₃/R (Pa) of a point on the path dε₁ + 2R dε₃ = 0 at σ₃.
inline sim::GrainPathPoint path_point(double axial_strain, double path_stress, double R,
                                      double radial_stress = 60e3) {
  sim::GrainPathPoint at;
  at.time_s = axial_strain / 0.1;
  at.strain = {axial_strain, -axial_strain / (2 * R)};
  at.volumetric_strain = sim::volumetric_strain(at.strain);
  at.stress = {path_stress + radial_stress / R, radial_stress};
  at.p_pa = sim::mean_stress(at.stress);
  at.q_pa = sim::deviator_stress(at.stress);
  at.path_stress_pa = path_stress;
  at.porosity = 0.4;
  at.coordination = 3.5;
  at.sliding_share = 0.02;
  at.kinetic_energy_j = 1e-6;
  at.unbalanced = 1e-4;
  return at;
}

/// σ₁ − σ₃/R rises by 1 kPa a point to 20 kPa at ε₁ = 0.2 % and falls by half a kPa a point to
/// 10 kPa at 0.4 %.
inline std::vector<sim::GrainPathPoint> rising_and_falling(double R) {
  std::vector<sim::GrainPathPoint> points;
  for (int i = 0; i <= 40; ++i)
    points.push_back(path_point(1e-4 * i, i <= 20 ? 1e3 * i : 20e3 - 500.0 * (i - 20), R));
  points[30].kinetic_energy_j = 3e-4;
  return points;
}

inline sim::GrainPath strain_path(double R) {
  sim::GrainPath path;
  path.kind = sim::GrainPathKind::strain_path;
  path.ratio = R;
  return path;
}

/// A probe of 1 kPa with W₂ and, beside it, a microscopic one `ratio` times as large.
inline sim::GrainProbe probe_at(double degrees, double work, double ratio = 1) {
  sim::GrainProbe probe;
  probe.angle = sim::radians(degrees);
  probe.norm_pa = 1000;
  probe.at_rest = true;
  probe.stress = {1000 * std::sin(probe.angle), 1000 * std::cos(probe.angle) / std::numbers::sqrt2};
  probe.strain = {1e-5 * std::sin(probe.angle), 1e-5 * std::cos(probe.angle) / std::numbers::sqrt2};
  probe.work.lagrangian = work;
  probe.work.fixed_frame = work;
  probe.work.stress_part = 0.9 * work;
  probe.work.volume_part = 0.01 * work;
  probe.work.transport_part = 0.09 * work;
  probe.work.normalised = work / 0.01;
  probe.work.normal_part = 0.75 * ratio * work;
  probe.work.tangential_part = 0.25 * ratio * work;
  probe.work.grains_turning = 0.9 * (ratio - 1) * work;
  probe.work.contacts_turning = 0.06 * (ratio - 1) * work;
  probe.work.out_of_balance = 0.03 * (ratio - 1) * work;
  probe.work.boundary_part = -3 * work;
  probe.ledger.walls_j = 2e-6;
  probe.ledger.elastic_start_j = 1e-6;
  probe.ledger.elastic_end_j = 2e-6;
  probe.ledger.friction_j = 9e-7;
  probe.ledger.damping_j = 9e-8;
  probe.work.contacts_before = 1000;
  probe.work.opened = 1;
  probe.sliding_share = 0.003;
  probe.most_kinetic_j = 1e-9;
  probe.steps = 4000;
  return probe;
}

/// Every 10°: W₂ = 0.01 J/m³, −0.002 at 220° and 230°; the microscopic one 20 % more from 70° to
/// 220° and 1 % more elsewhere; from 50° to 260° five in a hundred contacts slide; from 80° to 210°
/// there is motion; 140° does not come to rest. The null probe strains by 1e-8.
inline sim::ProbeRose rose() {
  sim::ProbeRose made;
  for (int degrees = 0; degrees < 360; degrees += 10) {
    const bool unstable = degrees == 220 || degrees == 230, apart = degrees >= 70 && degrees <= 220;
    sim::GrainProbe probe = probe_at(degrees, unstable ? -0.002 : 0.01, apart ? 1.2 : 1.01);
    if (degrees >= 50 && degrees <= 260) probe.sliding_share = 0.05;
    if (degrees >= 80 && degrees <= 210) probe.most_kinetic_j = 1e-6;
    probe.at_rest = degrees != 140;
    made.probes.push_back(probe);
  }
  made.null_probe = probe_at(0, 0);
  made.null_probe.norm_pa = 0;
  made.null_probe.strain = {1e-8, 0};
  made.null_probe.most_kinetic_j = 1e-12;
  return made;
}

inline std::vector<sim::PerturbationPoint> decaying(double end_share) {
  std::vector<sim::PerturbationPoint> points;
  for (int i = 0; i <= 10; ++i) {
    sim::PerturbationPoint at;
    at.time_s = 0.01 * i;
    at.stress_share = std::lerp(1.0, end_share, 0.1 * i);
    at.path_stress_pa = 25e3 * at.stress_share;
    at.p_pa = 80e3 * at.stress_share;
    at.axial_strain = 1e-4 * i;
    at.kinetic_energy_j = end_share < 0.5 ? 1e-9 * std::pow(10, 0.5 * i) : 1e-9;
    points.push_back(at);
  }
  return points;
}

inline lab::GrainStage stage(const std::string& name, const std::string& action,
                             const std::string& from = {}) {
  lab::GrainStage one;
  one.name = name;
  one.action = action;
  one.from = from;
  return one;
}

/// Four spheres in a box; nothing touches.
inline lab::GrainsMade four_grains() {
  std::vector<sim::Sphere> spheres;
  for (int i = 0; i < 4; ++i) spheres.push_back({{0.01 * i + 0.01, 0.02, 0.02}, 1e-3 * (i + 1)});
  lab::GrainsMade made;
  made.state = sim::make_grain_state(spheres, {{0, 0, 0}, {0.05, 0.04, 0.04}}, {}, 2e-6);
  made.measures = sim::measure(made.state);
  made.compaction_friction_angle = sim::radians(14);
  made.trials = 3;
  return made;
}

inline lab::GrainProgramme sample_programme() {
  lab::GrainProgramme programme;
  programme.name = "sample";
  programme.source = "sample.toml";
  programme.grains.seed = 7;
  return programme;
}

/// Two strain paths, one with marks, a rose, two perturbations, a drained and an isotropic path and
/// a rest.
inline lab::GrainReport sample_run() {
  const lab::GrainProgramme programme = sample_programme();
  lab::GrainReport report{
      programme.name, programme.source, lab::reported(programme.grains, four_grains()), {}};
  const auto tell = [&](lab::GrainStage what, auto work, auto outcome) {
    what.work = work;
    lab::GrainStageResult result;
    result.stage = &what;
    result.outcome = std::move(outcome);
    if (result.outcome.index() != 2) result.ledger = probe_at(0, 0).ledger;
    report.stages.push_back(lab::reported(result));
  };
  const auto follow = [&](const char* name, const char* action, const sim::GrainPath& path,
                          std::vector<sim::GrainPathPoint> points, sim::GrainPathEnd end) {
    lab::GrainPathStage work;
    work.path = path;
    sim::GrainPathResult outcome;
    outcome.points = std::move(points);
    outcome.end = end;
    tell(stage(name, action), work, outcome);
  };
  sim::GrainPath isotropic, drained;
  isotropic.kind = sim::GrainPathKind::isotropic;
  follow("press", "isotropic", isotropic, {path_point(0, 0, 1), path_point(0.001, 0, 1, 90e3)},
         sim::GrainPathEnd::at_rest);
  follow("shear", "drained", drained, rising_and_falling(1), sim::GrainPathEnd::axial_strain);
  follow("R-0.8", "strain_path", strain_path(0.8), rising_and_falling(0.8),
         sim::GrainPathEnd::collapse);
  follow("R-1", "undrained", strain_path(1), rising_and_falling(1),
         sim::GrainPathEnd::axial_strain);
  lab::GrainRest rest;
  rest.at_rest = true;
  rest.settling.steps = 500;
  rest.path_stress_pa = 12.5e3;
  tell(stage("calm", "rest", "shear"), lab::GrainRestStage{}, rest);
  lab::GrainRose probes{{260e3, 200e3}, sim::rose_angles(), rose()};
  tell(stage("probes", "probes", "calm"), lab::GrainProbeStage{}, probes);
  lab::GrainPerturbationStage load, energy;
  load.perturbation.load_step_pa = 500;
  energy.perturbation.kinetic_energy_j = 1e-4;
  sim::PerturbationResult at_rest, collapsed;
  at_rest.end = sim::PerturbationEnd::at_rest;
  at_rest.points = decaying(1.02);
  collapsed.end = sim::PerturbationEnd::collapsed;
  collapsed.points = decaying(0.05);
  collapsed.grains_hit = 40;
  collapsed.most_kinetic_j = 1e-4;
  tell(stage("load a", "perturbation", "ES_a"), load, at_rest);
  tell(stage("load b", "perturbation", "ES_b"), load, collapsed);
  tell(stage("energy b", "perturbation", "ES_b"), energy, collapsed);
  // As if they had been taken out on the way: a mark passed and one that never was.
  auto& path = std::get<lab::ReportedGrainPath>(report.stages[2].came);
  path.marks = {{"ES_a", path.points[10]}, {"never", {}}};
  return report;
}

/// As if the database had given it.
inline db::StoredGrainRun stored(lab::GrainReport report) {
  return {3, db::TestStatus::complete, {}, "2026-01-01T00:00:00Z", std::move(report)};
}

}  // namespace triax::src::test

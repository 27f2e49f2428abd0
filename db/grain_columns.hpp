// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The columns of the tables of a run of grains, each list for writing and reading (exact_row.hpp).
// The order of numbers in a list is the order of their last bits: new ones go to its end.
#include <array>
#include <string>

#include "lab/grains/grain_report.hpp"
#include "lab/grains/grain_words.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::db {

template <class Row, class Measures>
void visit_measures(Row& row, Measures& m) {
  row("wall_stress_1_kPa", m.wall_stress_pa[0], "kPa");
  row("wall_stress_2_kPa", m.wall_stress_pa[1], "kPa");
  row("wall_stress_3_kPa", m.wall_stress_pa[2], "kPa");
  row("porosity", m.porosity);
  row("void_ratio", m.void_ratio);
  row("coordination", m.coordination);
  row("kinetic_energy_J", m.kinetic_energy_j);
  row("unbalanced", m.unbalanced);
  row("grain_contacts", m.grain_contacts);
  row("wall_contacts", m.wall_contacts);
  row("sliding_contacts", m.sliding_contacts);
  row("floating_grains", m.floating_grains);
  row("grains_outside", m.grains_outside);
}

/// Of grain_runs, beside what a specimen reports: words and what is empty where it was not made.
struct SpecimenRow {
  lab::ReportedGrains told;
  std::string reading;
  std::optional<std::int64_t> seed, compactions;
};

template <class Row, class Specimen>
void visit_specimen(Row& row, Specimen& s) {
  auto& g = s.told;
  row.or_null("state_file", g.state_file);
  row("grains", g.grains);
  row("seed", s.seed);
  row("compaction_friction_deg", g.compaction_friction, "deg");
  row("compactions", s.compactions);
  row("stiffness_reading", s.reading);
  row("stiffness_over_diameter_MPa", g.law.stiffness_over_diameter_pa, "MPa");
  row("tangential_ratio", g.law.tangential_ratio);
  row("friction_angle_deg", g.law.friction_angle, "deg");
  row("density_kg_per_m3", g.law.density_kg_per_m3);
  row("damping", g.law.damping);
  row("time_step_s", g.time_step_s);
  row("smallest_grain_mm", g.smallest_m, "mm");
  row("median_grain_mm", g.median_m, "mm");
  row("largest_grain_mm", g.largest_m, "mm");
  row("compaction_pressure_kPa", g.compaction_pressure, "kPa");
  row("porosity_wanted", g.porosity_wanted);
  row.follows("porosity", g.measures.porosity);
  row.follows("void_ratio", g.measures.void_ratio);
  row.follows("coordination", g.measures.coordination);
  row.follows("floating_grains", g.measures.floating_grains);
  row.follows("grains_outside", g.measures.grains_outside);
}

/// Of grain_stages, beside what every stage reports.
struct StageRow {
  lab::ReportedGrainStage told;
  std::int64_t number = 0;
  std::string ending;
  std::optional<std::int64_t> at_rest;
  std::optional<double> strain_path_ratio, seconds;
  double radial_stress_pa = 0;
};

template <class Row, class Stage>
void visit_stage(Row& row, Stage& s) {
  auto& after = s.told.after;
  row("number", s.number);
  row("name", s.told.name);
  row("action", s.told.action);
  row("started_from", s.told.from);
  row.follows("strain_path_R", s.strain_path_ratio);
  row("ending", s.ending);
  row("at_rest", s.at_rest);
  row.follows("porosity", after.porosity);
  row.follows("coordination", after.coordination);
  row.follows("floating_grains", after.floating_grains);
  row.follows("axial_stress_kPa", after.wall_stress_pa[sim::kAxial], "kPa");
  row.follows("radial_stress_kPa", s.radial_stress_pa, "kPa");
  row.follows("unbalanced", after.unbalanced);
  row.follows("kinetic_energy_J", after.kinetic_energy_j);
  row("engine_steps", s.told.steps);
  row.follows("wall_clock_s", s.seconds);
  row("axial_strain_at_start", s.told.strain_before.axial);
  row("radial_strain_at_start", s.told.strain_before.radial);
}

/// Of grain_points and grain_marks.
template <class Row, class Point>
void visit_point(Row& row, Point& p) {
  row("time_s", p.time_s);
  row("axial_strain_pct", p.strain.axial, "%");
  row("radial_strain_pct", p.strain.radial, "%");
  row("volumetric_strain_pct", p.volumetric_strain, "%");
  row("axial_stress_kPa", p.stress.axial, "kPa");
  row("radial_stress_kPa", p.stress.radial, "kPa");
  row("p_kPa", p.p_pa, "kPa");
  row("q_kPa", p.q_pa, "kPa");
  row("path_stress_kPa", p.path_stress_pa, "kPa");
  row("kinetic_energy_J", p.kinetic_energy_j);
  row("unbalanced", p.unbalanced);
  row("porosity", p.porosity);
  row("coordination", p.coordination);
  row("sliding_pct", p.sliding_share, "%");
}

struct PathRow {
  std::string kind;
  sim::GrainPath path;
};

template <class Row, class Path>
void visit_path(Row& row, Path& p) {
  row("kind", p.kind);
  row("R", p.path.ratio);
  row("strain_rate_per_s", p.path.strain_rate_per_s);
  row("load_rate_Pa_per_s", p.path.load_rate_pa_per_s);
  row("samples", p.path.samples);
}

struct MarkRow {
  std::string name;
  bool passed = false;
  sim::GrainPathPoint at;
};

template <class Row, class Mark>
void visit_mark(Row& row, Mark& m) {
  row("name", m.name);
  row("passed", m.passed);
  visit_point(row, m.at);
}

struct RestRow {
  std::string held;
  lab::GrainRest rest;
};

template <class Row, class Rest>
void visit_rest(Row& row, Rest& r) {
  row("held", r.held);
  row("engine_steps", r.rest.settling.steps);
  row("unbalanced", r.rest.settling.unbalanced);
  row("stress_error_Pa", r.rest.settling.stress_error_pa);
  row("path_stress_kPa", r.rest.path_stress_pa, "kPa");
}

/// What was probed, and with what; the norm of the other kind is empty.
struct RoseRow {
  std::string kind;
  std::optional<double> norm_pa, norm_strain;
  sim::AxisymmetricStress stress;
};

template <class Row, class Rose>
void visit_rose(Row& row, Rose& r) {
  row("norm_kPa", r.norm_pa, "kPa");
  row("axial_stress_kPa", r.stress.axial, "kPa");
  row("radial_stress_kPa", r.stress.radial, "kPa");
  row("norm_strain", r.norm_strain);
  row("probed", r.kind);
}

/// A probe and what follows from it.
struct ProbeRow {
  sim::GrainProbe probe;
  std::optional<double> angle;    ///< empty of the null probe
  std::optional<double> norm_pa;  ///< empty of strain probes
  double eulerian = 0, microscopic = 0, non_permanent_share = 0;
};

template <class Row, class Probe>
void visit_probe(Row& row, Probe& r) {
  auto& p = r.probe;
  auto& w = p.work;
  row("alpha_deg", r.angle, "deg");
  row("norm_kPa", r.norm_pa, "kPa");
  row("at_rest", p.at_rest);
  row("axial_strain", p.strain.axial);
  row("radial_strain", p.strain.radial);
  row("work_lagrangian_J_per_m3", w.lagrangian);
  row.follows("work_eulerian_J_per_m3", r.eulerian);
  row("stress_part_J_per_m3", w.stress_part);
  row("volume_part_J_per_m3", w.volume_part);
  row("transport_part_J_per_m3", w.transport_part);
  row.follows("work_microscopic_J_per_m3", r.microscopic);
  row("work_fixed_frame_J_per_m3", w.fixed_frame);
  row("boundary_part_J_per_m3", w.boundary_part);
  row("normalised_work", w.normalised);
  row("sliding_pct", p.sliding_share, "%");
  row.follows("non_permanent_pct", r.non_permanent_share, "%");
  row("largest_kinetic_energy_J", p.most_kinetic_j);
  row("engine_steps", p.steps);
  row("stopped", p.stopped);
  row("axial_stress_kPa", p.stress.axial, "kPa");
  row("radial_stress_kPa", p.stress.radial, "kPa");
  row("normal_part_J_per_m3", w.normal_part);
  row("tangential_part_J_per_m3", w.tangential_part);
  row("non_permanent_part_J_per_m3", w.non_permanent_part);
  row("contacts_before", w.contacts_before);
  row("contacts_opened", w.opened);
  row("contacts_closed", w.closed);
  row("unbalanced", p.unbalanced);
  row("stress_error_Pa", p.stress_error_pa);
}

/// What the macroscopic and the microscopic work of a probe differ by.
struct GapRow {
  std::int64_t number = 0;  ///< of the probe
  double contacts_turning = 0, grains_turning = 0, out_of_balance = 0, left = 0;
};

template <class Row, class Gap>
void visit_gap(Row& row, Gap& g) {
  row("number", g.number);
  row("contacts_turning_J_per_m3", g.contacts_turning);
  row("grains_turning_J_per_m3", g.grains_turning);
  row("out_of_balance_J_per_m3", g.out_of_balance);
  row.follows("left_J_per_m3", g.left);
}

/// Of a stage or a probe.
struct EnergyRow {
  std::int64_t number = 0;  ///< of the probe, or 0
  sim::GrainLedger ledger;
  double error_j = 0;
};

template <class Row, class Energy>
void visit_energy(Row& row, Energy& e) {
  auto& l = e.ledger;
  row("number", e.number);
  row("walls_J", l.walls_j);
  row("elastic_start_J", l.elastic_start_j);
  row("elastic_end_J", l.elastic_end_j);
  row("kinetic_start_J", l.kinetic_start_j);
  row("kinetic_end_J", l.kinetic_end_j);
  row("friction_J", l.friction_j);
  row("damping_J", l.damping_j);
  row("stopped_J", l.stopped_j);
  row.follows("error_J", e.error_j);
}

struct MomentumRow {
  std::int64_t number = 0;
  std::string axis;
  double walls = 0, damping = 0, stopped = 0, start = 0, end = 0;
};

template <class Row, class Momentum>
void visit_momentum(Row& row, Momentum& m) {
  row("number", m.number);
  row("axis", m.axis);
  row("walls_kg_m_per_s", m.walls);
  row("damping_kg_m_per_s", m.damping);
  row("stopped_kg_m_per_s", m.stopped);
  row("start_kg_m_per_s", m.start);
  row("end_kg_m_per_s", m.end);
}
inline const std::array<std::string, 3> kMomentumAxes{"x", "y", "z"};

template <class Row, class Perturbation>
void visit_perturbation(Row& row, Perturbation& p) {
  row("load_step_Pa", p.how.load_step_pa);
  row("kinetic_energy_J", p.how.kinetic_energy_j);
  row("grains_hit", p.grains_hit);
  row("largest_kinetic_energy_J", p.most_kinetic_j);
  row("floating_share", p.how.floating_share);
  row("seed", p.how.seed);
}

template <class Row, class Point>
void visit_perturbation_point(Row& row, Point& p) {
  row("time_s", p.time_s);
  row("path_stress_kPa", p.path_stress_pa, "kPa");
  row("stress_share", p.stress_share);
  row("p_kPa", p.p_pa, "kPa");
  row("axial_strain_pct", p.axial_strain, "%");
  row("kinetic_energy_J", p.kinetic_energy_j);
  row("unbalanced", p.unbalanced);
}

}  // namespace triax::db

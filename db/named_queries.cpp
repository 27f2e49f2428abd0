// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/query.hpp"

namespace triax::db {

const std::vector<NamedQuery>& named_queries() {
  static const std::vector<NamedQuery> queries{
      {"tests", "all tests: type, source, end, and whether statistics count them",
       "SELECT t.id AS test_id, t.name AS test, t.origin, t.programme, s.status, t.stored_at, "
       "s.readings, t.source, t.dialect, t.seed, "
       "t.id IN (SELECT test_id FROM counted_tests) AS counted "
       "FROM tests t JOIN seen_tests s ON s.test_id = t.id ORDER BY t.id"},
      {"collapse_points",
       "the tests that collapsed, as in tables of papers: p'0, e, phi, eta; each file once",
       "SELECT * FROM collapse_points ORDER BY type_of_test, test_id"},
      {"collapses",
       "the result of every test, with its onset of instability and its loss of control",
       "SELECT * FROM collapses ORDER BY test_id"},
      {"criteria", "the result of each criterion, with its evidence",
       "SELECT t.id AS test_id, t.name AS test, t.origin, c.name AS criterion, c.detected, "
       "c.reading, c.time_s, c.eta, c.detected_at_reading, c.detected_at_time_s, c.evidence "
       "FROM criteria c JOIN tests t ON t.id = c.test_id ORDER BY c.id"},
      {"peaks", "the peak of q of every test", "SELECT * FROM peaks ORDER BY test_id"},
      {"instability_line",
       "stress ratio at collapse by type of test, sense of shear, origin and kind: the slope of "
       "the instability line; each file once",
       "SELECT type_of_test, CASE WHEN eta < 0 THEN 'extension' ELSE 'compression' END AS sense, "
       "origin, kind, count(*) AS tests, avg(eta) AS eta_mean, "
       "min(eta) AS eta_min, max(eta) AS eta_max, avg(phi_mob_deg) AS phi_mob_mean_deg "
       "FROM collapse_points WHERE eta IS NOT NULL "
       "GROUP BY type_of_test, sense, origin, kind"},
      {"truths",
       "true onset and loss of control (model) of simulated specimens, and those that were found",
       "SELECT t.id AS test_id, t.name AS test, t.programme, u.lost_sustainability, "
       "u.time_s AS true_time_s, u.q_kPa / u.p_eff_kPa AS true_eta, c.kind AS found, "
       "c.time_s AS found_time_s, c.eta AS found_eta, "
       "r.start_s AS true_loss_of_control_s, c.loss_of_control_time_s AS found_loss_of_control_s "
       "FROM truths u JOIN tests t ON t.id = u.test_id "
       "LEFT JOIN run_aways r ON r.test_id = t.id AND r.number = 1 "
       "LEFT JOIN collapses c ON c.test_id = t.id ORDER BY t.id"},
      {"run_aways", "runaways of simulated specimens: motion and kinetic energy",
       "SELECT t.id AS test_id, t.name AS test, t.origin, r.number, r.start_s, "
       "r.largest_kinetic_energy_J, r.largest_at_s, r.kinetic_energy_J, r.second_order_work_J, "
       "-2 * r.kinetic_energy_J / r.second_order_work_J AS kinetic_energy_over_half_work, "
       "r.end_s, r.ending, r.axial_strain, r.q_kPa, r.p_eff_kPa, r.pore_pressure_kPa "
       "FROM run_aways r JOIN tests t ON t.id = r.test_id ORDER BY t.id, r.number"},
      {"sweep", "the tests of every sweep: each varied key with its value, and the result",
       "SELECT r.* FROM sweep_results r JOIN sweep_members m ON m.test_id = r.test_id "
       "AND m.key = r.key ORDER BY r.sweep, r.place, m.position"},
      {"grain_runs", "runs of grain specimens: preparation and properties",
       "SELECT r.id AS run_id, r.name AS run, r.origin, s.status, recorded_at, grains, seed, "
       "compaction_friction_deg, friction_angle_deg, stiffness_reading, porosity, void_ratio, "
       "coordination, floating_grains, grains_outside, source "
       "FROM grain_runs r JOIN seen_grain_runs s ON s.run_id = r.id ORDER BY r.id"},
      {"grain_stages", "the stages of every run of grains, and how each ended",
       "SELECT r.id AS run_id, r.name AS run, r.origin, s.number AS stage, s.name AS stage_name, "
       "s.action, s.started_from, s.strain_path_R, s.ending, s.porosity, s.coordination, "
       "s.axial_stress_kPa, s.radial_stress_kPa, s.unbalanced, s.kinetic_energy_J, s.engine_steps, "
       "s.wall_clock_s FROM grain_stages s JOIN grain_runs r ON r.id = s.run_id "
       "ORDER BY r.id, s.number"},
      {"grain_peaks", "peak of s1 - s3/R of every path of grains, and what followed",
       "SELECT * FROM grain_peaks ORDER BY run_id, stage"},
      {"grain_probes", "second-order work of every probe of grains; number 0 is the null probe",
       "SELECT r.name AS run, r.origin, s.name AS stage_name, p.* FROM grain_probes p "
       "JOIN grain_runs r ON r.id = p.run_id "
       "JOIN grain_stages s ON s.run_id = p.run_id AND s.number = p.stage "
       "ORDER BY p.run_id, p.stage, p.number"},
      {"grain_perturbations", "equilibria of grains that were perturbed: sustained or collapsed",
       "SELECT r.name AS run, r.origin, s.name AS stage_name, s.started_from, s.strain_path_R, "
       "s.ending, p.* FROM grain_perturbations p JOIN grain_runs r ON r.id = p.run_id "
       "JOIN grain_stages s ON s.run_id = p.run_id AND s.number = p.stage "
       "ORDER BY p.run_id, p.stage"},
      {"specimens", "dimensions and void ratio of every specimen, as built and consolidated",
       "SELECT t.id AS test_id, t.name AS test, t.origin, s.material, s.height_mm, s.diameter_mm, "
       "s.void_ratio, k.p_eff_kPa AS p0_eff_kPa, k.b_value, "
       "coalesce(k.void_ratio, s.consolidated_void_ratio) AS consolidated_void_ratio, "
       "coalesce(k.height_mm, s.consolidated_height_mm) AS consolidated_height_mm, "
       "k.diameter_mm AS consolidated_diameter_mm "
       "FROM tests t LEFT JOIN specimens s ON s.test_id = t.id "
       "LEFT JOIN consolidations k ON k.test_id = t.id ORDER BY t.id"},
      {"reference_results",
       "results that laboratories reported without readings (AGS4), to compare tests with",
       "SELECT source, group_name, location, sample_reference, sample_type, sample_id, "
       "specimen_reference, specimen_depth_m, test_type, stage, consolidation_pressure_kPa, "
       "cell_pressure_kPa, pore_pressure_kPa, q_kPa, p_eff_kPa, s_eff_kPa, t_kPa, "
       "axial_strain_pct, undrained_strength_kPa, failure_mode, initial_water_content_pct, "
       "bulk_density_Mg_m3, dry_density_Mg_m3, cohesion_kPa, friction_angle_deg, line "
       "FROM reference_results ORDER BY source_path, id"},
      {"stages", "the stages of every test",
       "SELECT t.id AS test_id, t.name AS test, t.origin, s.number, s.name AS stage, s.role, "
       "s.drainage, s.control "
       "FROM stages s JOIN tests t ON t.id = s.test_id ORDER BY t.id, s.number"},
      {"events", "events, in order of detection",
       "SELECT t.id AS test_id, t.name AS test, t.origin, e.reading, e.time_s, e.kind, "
       "e.detected_at_reading, e.detected_at_time_s, e.detail "
       "FROM events e JOIN tests t ON t.id = e.test_id ORDER BY t.id, e.id"},
      {"alarms", "first warnings of the alarm that were not withdrawn, with the onset found",
       "SELECT t.id AS test_id, t.name AS test, t.origin, o.level, o.reading, o.time_s, "
       "o.eta_forecast, o.eta_low, o.eta_high, o.left_quantity, o.left_value, o.left_time_s, "
       "o.failure_probability, o.load_cycles, "
       "c.kind, c.reading AS onset_reading, c.time_s AS onset_time_s, c.eta AS onset_eta "
       "FROM outlooks o JOIN tests t ON t.id = o.test_id "
       "LEFT JOIN collapses c ON c.test_id = o.test_id ORDER BY t.id, o.reading"},
      {"forecasts", "forecasts of the onset while tests ran, at every point of W2",
       "SELECT * FROM forecasts ORDER BY test_id, reading"},
      {"checks", "measured values compared with acceptable limits",
       "SELECT t.id AS test_id, t.name AS test, t.origin, c.name AS check_name, c.measured, "
       "c.limit_value, c.ok, c.note "
       "FROM checks c JOIN tests t ON t.id = c.test_id ORDER BY t.id, c.id"},
      {"warnings", "corrections, joins and missing rows of the records",
       "SELECT DISTINCT t.id AS test_id, t.name AS test, t.origin, w.line, w.text "
       "FROM warnings w JOIN tests t ON t.id = w.test_id ORDER BY t.id, w.line"},
      {"revisions",
       "corrections of stored tests, with the old and the new value and the old result",
       "SELECT t.id AS test_id, t.name AS test, t.origin, r.revision, r.revised_at, v.key, "
       "v.old_value, v.new_value, r.former_kind, r.former_eta "
       "FROM revisions r JOIN tests t ON t.id = r.test_id "
       "JOIN revised_values v ON v.test_id = r.test_id AND v.revision = r.revision "
       "ORDER BY t.id, r.revision, v.position"},
      {"unfinished_tests", "tests that are running or were interrupted, with the last heartbeat",
       "SELECT * FROM unfinished_tests ORDER BY test_id"},
  };
  return queries;
}

}  // namespace triax::db

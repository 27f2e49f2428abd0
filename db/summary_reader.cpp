// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/summary_reader.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "db/columns.hpp"
#include "db/test_rows.hpp"
#include "lab/results/reading.hpp"

namespace triax::db {
namespace {

lab::Instant read_values(Columns& c) {
  lab::Instant instant;
  instant.reading = c.integer().value_or(0);
  instant.time_s = c.number();
  instant.axial_strain = c.number();
  instant.q_pa = c.si("kPa");
  instant.p_eff_pa = c.si("kPa");
  instant.pore_pressure_pa = c.si("kPa");
  return instant;
}

std::optional<lab::Instant> read_instant(SQLite::Database& database, std::int64_t id,
                                         std::string_view kind) {
  std::optional<lab::Instant> result;
  for_rows(database, id,
           "SELECT kind, reading, time_s, axial_strain, q_kPa, p_eff_kPa, pore_pressure_kPa "
           "FROM instants WHERE test_id = ?",
           [&](Columns& c) {
             if (c.text() == kind) result = read_values(c);
           });
  return result;
}

std::optional<lab::StressInterval> read_interval(Columns& c) {
  std::array<std::optional<double>, 6> ends = {c.number(), c.number()};
  for (std::size_t i = 2; i < ends.size(); ++i) ends[i] = c.si("kPa");
  for (const auto& end : ends)
    if (!end) return std::nullopt;
  return lab::StressInterval{
      .q_pa = {*ends[2], *ends[3]}, .p_eff_pa = {*ends[4], *ends[5]}, .eta = {*ends[0], *ends[1]}};
}

std::optional<lab::TotalUncertainty> read_total(Columns& c) {
  const auto interval = read_interval(c);
  const std::string budget = c.text();
  if (!interval) return std::nullopt;
  lab::TotalUncertainty total{.interval = *interval, .budget = {}};
  const auto list = nlohmann::json::parse(budget, nullptr, false);
  if (!list.is_array()) return total;
  for (const auto& source : list)
    if (source.is_object())
      total.budget.push_back({source.value("name", ""), source.value("share", 0.0)});
  return total;
}

void read_loss_of_control(SQLite::Database& database, std::int64_t id, lab::Collapse& collapse) {
  for_rows(database, id,
           "SELECT reading, time_s, axial_strain, q_kPa, p_eff_kPa, pore_pressure_kPa, eta_low, "
           "eta_high, q_low_kPa, q_high_kPa, p_eff_low_kPa, p_eff_high_kPa, detected_at_reading, "
           "detected_at_time_s FROM losses_of_control WHERE test_id = ?",
           [&](Columns& c) {
             collapse.loss_of_control = read_values(c);
             collapse.loss_of_control->interval = read_interval(c);
             collapse.loss_of_control_detected_at = read_moment(c);
           });
}

void read_collapse(SQLite::Database& database, std::int64_t id, lab::Collapse& collapse) {
  std::optional<lab::StressInterval> interval;
  std::optional<lab::TotalUncertainty> total;
  for_rows(
      database, id,
      "SELECT kind, inside_limit_surface, second_order_work_normalised, second_order_work_error, "
      "limit_stress_ratio, limit_source, judged_until_reading, judged_until_reason, "
      "judged_from_reading, strength_lost, eta_low, eta_high, q_low_kPa, q_high_kPa, "
      "p_eff_low_kPa, p_eff_high_kPa, detected_at_reading, detected_at_time_s, "
      "limit_intercept_kPa, total_eta_low, total_eta_high, total_q_low_kPa, total_q_high_kPa, "
      "total_p_eff_low_kPa, total_p_eff_high_kPa, uncertainty_budget, nearest_reading, "
      "nearest_normalised, nearest_error FROM verdicts WHERE test_id = ?",
      [&](Columns& c) {
        const auto kind = lab::collapse_kind_from(c.text());
        collapse.judged = kind.has_value();
        collapse.kind = kind.value_or(lab::CollapseKind::none);
        collapse.inside_limit_surface = c.truth();
        collapse.second_order_work_normalised = c.number();
        collapse.second_order_work_error = c.number();
        collapse.limit_stress_ratio = c.number();
        collapse.limit_source = c.text();
        collapse.judged_until = c.integer();
        collapse.judged_until_reason = c.text();
        collapse.judged_from = c.integer();
        collapse.strength_lost = c.number();
        interval = read_interval(c);
        collapse.onset_detected_at = read_moment(c);
        collapse.limit_intercept_pa = c.si("kPa");
        total = read_total(c);
        if (const auto reading = c.integer())
          collapse.nearest = lab::Nearest{*reading, c.number().value_or(0), c.number().value_or(0)};
      });
  collapse.onset = read_instant(database, id, "onset");
  if (collapse.onset) collapse.onset->interval = interval;
  if (collapse.onset) collapse.onset->total = total;
  read_loss_of_control(database, id, collapse);
  for_rows(database, id,
           "SELECT name, detected, reading, time_s, eta, evidence, detected_at_reading, "
           "detected_at_time_s FROM criteria WHERE test_id = ? ORDER BY id",
           [&](Columns& c) {
             lab::Criterion& criterion = collapse.criteria.emplace_back();
             criterion.name = c.text();
             criterion.detected = c.truth();
             criterion.reading = c.integer();
             criterion.time_s = c.number();
             criterion.eta = c.number();
             criterion.evidence = c.text();
             criterion.detected_at = read_moment(c);
           });
}

std::optional<lab::LeftToOnset> read_left(Columns& c) {
  const std::string heading = c.text();
  for (const lab::QuantityInfo& row : lab::quantities()) {
    if (heading.empty() || lab::heading(row.quantity) != heading) continue;
    lab::LeftToOnset left{.quantity = row.quantity, .value = 0, .time_s = {}};
    left.value = lab::from_field_units(row.quantity, c.number().value_or(0));
    left.time_s = c.number();
    return left;
  }
  return std::nullopt;
}

lab::Forecast read_forecast(Columns& c) {
  lab::Forecast o;
  o.reading = c.integer().value_or(0);
  o.time_s = c.number();
  o.eta = c.number().value_or(lab::kMissing);
  o.eta_low = c.number().value_or(lab::kMissing);
  o.eta_high = c.number().value_or(lab::kMissing);
  o.left = read_left(c);
  return o;
}

void read_warnings(SQLite::Database& database, std::int64_t id, lab::Collapse& collapse) {
  for_rows(
      database, id,
      "SELECT level, failure_probability, load_cycles, reading, time_s, eta_forecast, eta_low, "
      "eta_high, left_quantity, left_value, left_time_s FROM outlooks WHERE test_id = ?",
      [&](Columns& c) {
        const bool imminent = lab::warning_level_from(c.text()) == lab::WarningLevel::imminent;
        auto& forecast = imminent ? collapse.imminent : collapse.approaching;
        const auto probability = c.number();
        const auto load_cycles = c.number();
        forecast = read_forecast(c);
        if (probability && load_cycles) forecast->cyclic = {*probability, *load_cycles};
      });
}

void read_undrained_strength(SQLite::Database& database, std::int64_t id,
                             std::optional<lab::UndrainedStrength>& strength) {
  for_rows(database, id,
           "SELECT reading, time_s, axial_strain, q_kPa, peaked, last_axial_strain, "
           "reading_at_15_pct, time_at_15_pct_s, axial_strain_at_15_pct, q_at_15_pct_kPa "
           "FROM undrained_strengths WHERE test_id = ?",
           [&](Columns& c) {
             const auto read = [&](std::int64_t reading) {
               lab::Instant at;
               at.reading = reading;
               at.time_s = c.number();
               at.axial_strain = c.number();
               at.q_pa = c.si("kPa");
               return at;
             };
             lab::UndrainedStrength& all = strength.emplace();
             all.at = read(c.integer().value_or(0));
             all.peaked = c.truth().value_or(true);
             all.last_axial_strain = c.number().value_or(0);
             if (const auto reading = c.integer()) all.at_15_pct = read(*reading);
           });
}

void read_cyclic(SQLite::Database& database, std::int64_t id,
                 std::optional<lab::CyclicLoading>& cyclic) {
  for_rows(database, id,
           "SELECT cycles, q_low_kPa, q_high_kPa, cyclic_stress_ratio, "
           "largest_pore_pressure_ratio, largest_double_amplitude, liquefied_reading, "
           "liquefied_cycle, double_amplitude_reading, double_amplitude_cycle "
           "FROM cyclic_loadings WHERE test_id = ?",
           [&](Columns& c) {
             lab::CyclicLoading& all = cyclic.emplace();
             all.cycles = c.number().value_or(0);
             all.q_low_pa = c.si("kPa").value_or(0);
             all.q_high_pa = c.si("kPa").value_or(0);
             all.stress_ratio = c.number().value_or(0);
             all.largest_pore_pressure_ratio = c.number().value_or(0);
             all.largest_double_amplitude = c.number().value_or(0);
             for (auto* at : {&all.liquefied, &all.double_amplitude}) {
               const auto reading = c.integer(), cycle = c.integer();
               if (!reading) continue;
               at->emplace().instant.reading = *reading;
               (*at)->cycle = static_cast<int>(cycle.value_or(1));
             }
           });
}

void read_guard(SQLite::Database& database, std::int64_t id,
                std::optional<lab::GuardOutcome>& outcome) {
  for_rows(database, id,
           "SELECT level, done, reading, time_s, axial_strain, q_kPa, p_eff_kPa, "
           "second_order_work_normalised, last_axial_strain, without_kind, "
           "without_last_axial_strain, without_lost_reading, without_lost_time_s FROM guards "
           "WHERE test_id = ?",
           [&](Columns& c) {
             lab::GuardOutcome& guard = outcome.emplace();
             guard.level = known(c.text(), lab::warning_level_from);
             guard.done = c.text();
             guard.at.reading = c.integer().value_or(0);
             guard.at.time_s = c.number();
             guard.at.axial_strain = c.number();
             guard.at.q_pa = c.si("kPa");
             guard.at.p_eff_pa = c.si("kPa");
             guard.second_order_work_normalised = c.number();
             guard.last_axial_strain = c.number();
             const auto kind = lab::collapse_kind_from(c.text());
             if (!kind) return;
             guard.without = {.kind = *kind, .last_axial_strain = c.number(), .lost = {}};
             guard.without->lost = read_moment(c);
           });
}

void read_consolidation_and_checks(SQLite::Database& database, std::int64_t id,
                                   lab::TestSummary& summary) {
  for_rows(database, id,
           "SELECT p_eff_kPa, b_value, void_ratio, height_mm, diameter_mm FROM consolidations "
           "WHERE test_id = ?",
           [&](Columns& c) {
             summary.consolidation.p_eff_pa = c.si("kPa");
             summary.consolidation.b_value = c.number();
             summary.consolidation.void_ratio = c.number();
             summary.consolidation.height_m = c.si("mm");
             summary.consolidation.diameter_m = c.si("mm");
           });
  for_rows(database, id,
           "SELECT name, measured, limit_value, ok, note FROM checks WHERE test_id = ? ORDER BY id",
           [&](Columns& c) {
             lab::Check& check = summary.checks.emplace_back();
             check.kind = known(c.text(), lab::check_kind_from);
             check.measured = c.number();
             check.limit = c.number();
             check.ok = c.truth().value_or(false);
             check.note = c.text();
           });
}

void read_truth(SQLite::Database& database, std::int64_t id, std::optional<lab::Truth>& truth) {
  for_rows(database, id,
           "SELECT lost_sustainability, time_s, axial_strain, q_kPa, p_eff_kPa, pore_pressure_kPa "
           "FROM truths WHERE test_id = ?",
           [&](Columns& c) {
             truth.emplace();
             truth->lost_sustainability = c.truth().value_or(false);
             truth->time_s = c.number();
             truth->axial_strain = c.number();
             truth->q_pa = c.si("kPa");
             truth->p_eff_pa = c.si("kPa");
             truth->pore_pressure_pa = c.si("kPa");
           });
  for_rows(database, id,
           "SELECT start_s, largest_kinetic_energy_J, largest_at_s, kinetic_energy_J, "
           "second_order_work_J, expected_ratio, end_s, ending, axial_strain, q_kPa, p_eff_kPa, "
           "pore_pressure_kPa FROM run_aways WHERE test_id = ? ORDER BY number",
           [&](Columns& c) {
             if (!truth) return;
             lab::RunAwayTruth& run_away = truth->run_aways.emplace_back();
             run_away.start_s = c.number().value_or(0);
             run_away.largest_kinetic_energy_j = c.number().value_or(0);
             run_away.largest_at_s = c.number().value_or(0);
             run_away.kinetic_energy_j = c.number();
             run_away.second_order_work_j = c.number();
             run_away.expected_ratio = c.number();
             run_away.end_s = c.number();
             run_away.end = known(c.text(), lab::run_away_end_from);
             run_away.axial_strain = c.number();
             run_away.q_pa = c.si("kPa");
             run_away.p_eff_pa = c.si("kPa");
             run_away.pore_pressure_pa = c.si("kPa");
           });
}

}  // namespace

void read_summary(SQLite::Database& database, std::int64_t id, lab::TestSummary& summary) {
  read_consolidation_and_checks(database, id, summary);
  summary.peak = read_instant(database, id, "peak");
  read_undrained_strength(database, id, summary.undrained_strength);
  read_collapse(database, id, summary.collapse);
  read_warnings(database, id, summary.collapse);
  read_cyclic(database, id, summary.cyclic);
  read_guard(database, id, summary.guard);
  read_truth(database, id, summary.truth);
}

std::vector<lab::Forecast> read_forecasts(SQLite::Database& database, std::int64_t id) {
  std::vector<lab::Forecast> forecasts;
  for_rows(database, id,
           "SELECT id & 4294967295, time_s, eta_forecast, eta_low, eta_high, left_quantity, "
           "left_value, left_time_s FROM forecast_points "
           "WHERE id BETWEEN ?1 << 32 AND ?1 << 32 | 4294967295 ORDER BY id",
           [&](Columns& c) { forecasts.push_back(read_forecast(c)); });
  return forecasts;
}

}  // namespace triax::db

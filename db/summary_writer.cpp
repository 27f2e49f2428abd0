// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/summary_writer.hpp"

#include <SQLiteCpp/Statement.h>

#include <nlohmann/json.hpp>

#include "db/columns.hpp"
#include "db/test_rows.hpp"

namespace triax::db {
namespace {

using SQLite::Statement;

void insert_consolidation(SQLite::Database& database, std::int64_t id,
                          const lab::Consolidation& c) {
  Statement insert(database, "INSERT INTO consolidations VALUES (?,?,?,?,?,?)");
  Binder(insert)
      .integer(id)
      .si(c.p_eff_pa, "kPa")
      .number(c.b_value)
      .number(c.void_ratio)
      .si(c.height_m, "mm")
      .si(c.diameter_m, "mm")
      .run();
}

void bind_instant(Binder& row, const lab::Instant& instant) {
  row.integer(instant.reading)
      .number(instant.time_s)
      .number(instant.axial_strain)
      .si(instant.q_pa, "kPa")
      .si(instant.p_eff_pa, "kPa")
      .si(instant.pore_pressure_pa, "kPa");
}

void insert_instant(SQLite::Database& database, std::int64_t id, std::string_view kind,
                    const std::optional<lab::Instant>& instant) {
  if (!instant) return;
  Statement insert(database, "INSERT INTO instants VALUES (?,?,?,?,?,?,?,?)");
  Binder row(insert);
  row.integer(id).text(kind);
  bind_instant(row, *instant);
  row.run();
}

void insert_cyclic(SQLite::Database& database, std::int64_t id,
                   const std::optional<lab::CyclicLoading>& cyclic) {
  if (!cyclic) return;
  const auto reading = [](const auto& at) {
    return at ? std::optional(at->instant.reading) : std::nullopt;
  };
  const auto cycle = [](const auto& at) {
    return at ? std::optional<std::int64_t>(at->cycle) : std::nullopt;
  };
  Statement insert(database, "INSERT INTO cyclic_loadings VALUES (?,?,?,?,?,?,?,?,?,?,?)");
  Binder(insert)
      .integer(id)
      .number(cyclic->cycles)
      .si(cyclic->q_low_pa, "kPa")
      .si(cyclic->q_high_pa, "kPa")
      .number(cyclic->stress_ratio)
      .number(cyclic->largest_pore_pressure_ratio)
      .number(cyclic->largest_double_amplitude)
      .integer(reading(cyclic->liquefied))
      .integer(cycle(cyclic->liquefied))
      .integer(reading(cyclic->double_amplitude))
      .integer(cycle(cyclic->double_amplitude))
      .run();
}

void insert_undrained_strength(SQLite::Database& database, std::int64_t id,
                               const std::optional<lab::UndrainedStrength>& strength) {
  if (!strength) return;
  Statement insert(database, "INSERT INTO undrained_strengths VALUES (?,?,?,?,?,?,?,?,?,?,?,?)");
  const lab::Instant& at = strength->at;
  const lab::Instant later = strength->at_15_pct.value_or(lab::Instant{});
  Binder(insert)
      .integer(id)
      .si(strength->c_u_pa(), "kPa")
      .integer(at.reading)
      .number(at.time_s)
      .number(at.axial_strain)
      .si(at.q_pa, "kPa")
      .integer(strength->peaked)
      .number(strength->last_axial_strain)
      .integer(strength->at_15_pct ? std::optional(later.reading) : std::nullopt)
      .number(later.time_s)
      .number(later.axial_strain)
      .si(later.q_pa, "kPa")
      .run();
}

void bind_interval(Binder& row, const std::optional<lab::StressInterval>& of) {
  const lab::StressInterval known = of.value_or(lab::StressInterval{});
  const auto if_known = [&](double value) { return of ? std::optional(value) : std::nullopt; };
  row.number(if_known(known.eta.low)).number(if_known(known.eta.high));
  for (const lab::Interval& interval : {known.q_pa, known.p_eff_pa})
    row.si(if_known(interval.low), "kPa").si(if_known(interval.high), "kPa");
}

std::string budget_json(const lab::TotalUncertainty& total) {
  auto list = nlohmann::json::array();
  for (const lab::UncertaintySource& source : total.budget)
    list.push_back({{"name", source.name}, {"share", source.share}});
  return list.dump();
}

void bind_total(Binder& row, const std::optional<lab::Instant>& onset) {
  const auto total = onset ? onset->total : std::nullopt;
  bind_interval(row, total ? std::optional(total->interval) : std::nullopt);
  row.text_or_null(total ? budget_json(*total) : std::string());
}

void insert_loss_of_control(SQLite::Database& database, std::int64_t id, const lab::Collapse& c) {
  if (!c.loss_of_control) return;
  Statement insert(database,
                   "INSERT INTO losses_of_control VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  Binder row(insert);
  row.integer(id);
  bind_instant(row, *c.loss_of_control);
  bind_interval(row, c.loss_of_control->interval);
  bind_moment(row, c.loss_of_control_detected_at);
  row.run();
}

void insert_verdict(SQLite::Database& database, std::int64_t id, const lab::Collapse& c) {
  Statement insert(database,
                   "INSERT INTO verdicts VALUES "
                   "(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  Binder row(insert);
  row.integer(id)
      .text_or_null(c.judged ? to_string(c.kind) : std::string_view())
      .integer(c.inside_limit_surface)
      .number(c.second_order_work_normalised)
      .number(c.second_order_work_error)
      .number(c.limit_stress_ratio)
      .text_or_null(c.limit_source)
      .integer(c.judged_until)
      .text_or_null(c.judged_until_reason)
      .integer(c.judged_from)
      .number(c.strength_lost)
      .integer(c.nearest ? std::optional(c.nearest->reading) : std::nullopt)
      .number(c.nearest ? std::optional(c.nearest->normalised) : std::nullopt)
      .number(c.nearest ? std::optional(c.nearest->error) : std::nullopt);
  bind_interval(row, c.onset ? c.onset->interval : std::nullopt);
  bind_moment(row, c.onset_detected_at);
  row.si(c.limit_intercept_pa, "kPa");
  bind_total(row, c.onset);
  row.run();
  insert_instant(database, id, "onset", c.onset);
  insert_loss_of_control(database, id, c);
  Statement criterion(
      database,
      "INSERT INTO criteria (test_id, name, detected, reading, time_s, eta, "
      "evidence, detected_at_reading, detected_at_time_s) VALUES (?,?,?,?,?,?,?,?,?)");
  for (const lab::Criterion& found : c.criteria) {
    Binder of_criterion(criterion);
    of_criterion.integer(id)
        .text(found.name)
        .integer(found.detected)
        .integer(found.reading)
        .number(found.time_s)
        .number(found.eta)
        .text_or_null(found.evidence);
    bind_moment(of_criterion, found.detected_at);
    of_criterion.run();
  }
}

/// All but its reading.
void bind_forecast(Binder& row, const lab::Forecast& forecast) {
  const auto& left = forecast.left;
  row.number(forecast.time_s)
      .number(forecast.eta)
      .number(forecast.eta_low)
      .number(forecast.eta_high)
      .text_or_null(left ? heading(left->quantity) : std::string())
      .number(left ? std::optional(in_field_units(*left)) : std::nullopt)
      .number(left ? left->time_s : std::nullopt);
}

void insert_warning(SQLite::Database& database, std::int64_t id, lab::WarningLevel level,
                    const std::optional<lab::Forecast>& forecast) {
  if (!forecast) return;
  Statement insert(database, "INSERT INTO outlooks VALUES (?,?,?,?,?,?,?,?,?,?,?,?)");
  Binder row(insert);
  row.integer(id).text(to_string(level)).integer(forecast->reading);
  bind_forecast(row, *forecast);
  const auto& cyclic = forecast->cyclic;
  row.number(cyclic ? std::optional(cyclic->probability) : std::nullopt)
      .number(cyclic ? std::optional(cyclic->load_cycles) : std::nullopt)
      .run();
}

void insert_guard(SQLite::Database& database, std::int64_t id,
                  const std::optional<lab::GuardOutcome>& guard) {
  if (!guard) return;
  Statement insert(database, "INSERT INTO guards VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  Binder row(insert);
  row.integer(id)
      .text(to_string(guard->level))
      .text(guard->done)
      .integer(guard->at.reading)
      .number(guard->at.time_s)
      .number(guard->at.axial_strain)
      .si(guard->at.q_pa, "kPa")
      .si(guard->at.p_eff_pa, "kPa")
      .number(guard->second_order_work_normalised)
      .number(guard->last_axial_strain);
  const auto& without = guard->without;
  row.text_or_null(without ? std::string(to_string(without->kind)) : std::string())
      .number(without ? without->last_axial_strain : std::nullopt);
  bind_moment(row, without ? without->lost : std::nullopt);
  row.run();
}

void insert_run_aways(SQLite::Database& database, std::int64_t id,
                      const std::vector<lab::RunAwayTruth>& run_aways) {
  Statement insert(database, "INSERT INTO run_aways VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  int number = 0;
  for (const lab::RunAwayTruth& run_away : run_aways)
    Binder(insert)
        .integer(id)
        .integer(++number)
        .number(run_away.start_s)
        .number(run_away.largest_kinetic_energy_j)
        .number(run_away.largest_at_s)
        .number(run_away.kinetic_energy_j)
        .number(run_away.second_order_work_j)
        .number(run_away.expected_ratio)
        .number(run_away.end_s)
        .text_or_null(to_string(run_away.end))
        .number(run_away.axial_strain)
        .si(run_away.q_pa, "kPa")
        .si(run_away.p_eff_pa, "kPa")
        .si(run_away.pore_pressure_pa, "kPa")
        .run();
}

void insert_truth(SQLite::Database& database, std::int64_t id,
                  const std::optional<lab::Truth>& truth) {
  if (!truth) return;
  Statement insert(database, "INSERT INTO truths VALUES (?,?,?,?,?,?,?)");
  Binder(insert)
      .integer(id)
      .integer(truth->lost_sustainability)
      .number(truth->time_s)
      .number(truth->axial_strain)
      .si(truth->q_pa, "kPa")
      .si(truth->p_eff_pa, "kPa")
      .si(truth->pore_pressure_pa, "kPa")
      .run();
  insert_run_aways(database, id, truth->run_aways);
}

void insert_checks(SQLite::Database& database, std::int64_t id,
                   const std::vector<lab::Check>& checks) {
  Statement insert(database,
                   "INSERT INTO checks (test_id, name, measured, limit_value, ok, note) "
                   "VALUES (?,?,?,?,?,?)");
  for (const lab::Check& check : checks)
    Binder(insert)
        .integer(id)
        .text(to_string(check.kind))
        .number(check.measured)
        .number(check.limit)
        .integer(check.ok)
        .text_or_null(check.note)
        .run();
}

}  // namespace

void insert_forecasts(SQLite::Database& database, std::int64_t test_id,
                      const std::vector<lab::Forecast>& forecasts) {
  if (forecasts.empty()) return;
  Statement insert(database,
                   "INSERT INTO forecast_points VALUES (?,?,?,?,?,?,?,?) "
                   // As of points of second-order work: the first at a reading stands.
                   "ON CONFLICT (id) DO NOTHING");
  for (const lab::Forecast& forecast : forecasts) {
    Binder row(insert);
    row.integer(test_id << 32 | forecast.reading);
    bind_forecast(row, forecast);
    row.run();
  }
}

void insert_summary(SQLite::Database& database, std::int64_t test_id,
                    const lab::TestSummary& summary) {
  insert_consolidation(database, test_id, summary.consolidation);
  insert_instant(database, test_id, "peak", summary.peak);
  insert_undrained_strength(database, test_id, summary.undrained_strength);
  insert_verdict(database, test_id, summary.collapse);
  insert_warning(database, test_id, lab::WarningLevel::approaching, summary.collapse.approaching);
  insert_warning(database, test_id, lab::WarningLevel::imminent, summary.collapse.imminent);
  insert_cyclic(database, test_id, summary.cyclic);
  insert_guard(database, test_id, summary.guard);
  insert_truth(database, test_id, summary.truth);
  insert_checks(database, test_id, summary.checks);
  insert_warnings(database, test_id, "at_end", summary.warnings);
  Statement complete(
      database,
      "UPDATE tests SET status = 'complete', readings = ?, membrane_correction = ? WHERE id = ?");
  Binder(complete)
      .integer(summary.readings)
      .text_or_null(summary.membrane_correction)
      .integer(test_id)
      .run();
}

}  // namespace triax::db

// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/test_writer.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include "db/columns.hpp"
#include "lab/base/text.hpp"

namespace triax::db {
namespace {

using SQLite::Statement;

std::string column_list(const std::vector<lab::Quantity>& columns) {
  std::string text;
  for (const lab::Quantity q : columns) {
    if (!text.empty()) text += ',';
    text += lab::heading(q);
  }
  return text;
}

void insert_specimen(SQLite::Database& database, std::int64_t id, const lab::SpecimenInfo& s) {
  Statement insert(database, "INSERT INTO specimens VALUES (?,?,?,?,?,?,?,?,?,?,?,?)");
  Binder(insert)
      .integer(id)
      .si(s.height_m, "mm")
      .si(s.diameter_m, "mm")
      .number(s.void_ratio)
      .number(s.consolidated_void_ratio)
      .si(s.consolidated_height_m, "mm")
      .si(s.dry_mass_kg, "g")
      .number(s.specific_gravity)
      .si(s.membrane_thickness_m, "mm")
      .si(s.membrane_modulus_pa, "kPa")
      .si(s.limit_friction_angle_rad, "deg")
      .text_or_null(s.material)
      .run();
}

void insert_stages(SQLite::Database& database, std::int64_t id,
                   const std::vector<lab::StageInfo>& stages) {
  Statement insert(database, "INSERT INTO stages VALUES (?,?,?,?,?,?,?)");
  for (const lab::StageInfo& stage : stages)
    Binder(insert)
        .integer(id)
        .integer(stage.number)
        .text(stage.name)
        .text(to_string(stage.role))
        .text(to_string(stage.drainage))
        .text(to_string(stage.control))
        .number(stage.strain_path_R)
        .run();
}

void insert_warnings(SQLite::Database& database, std::int64_t id, std::string_view found,
                     const std::vector<lab::Warning>& warnings) {
  Statement insert(database, "INSERT INTO warnings (test_id, found, line, text) VALUES (?,?,?,?)");
  for (const lab::Warning& warning : warnings)
    Binder(insert)
        .integer(id)
        .text(found)
        .integer(warning.line > 0 ? std::optional(warning.line) : std::nullopt)
        .text(warning.text)
        .run();
}

void insert_notes(SQLite::Database& database, std::int64_t id,
                  const std::vector<lab::Note>& notes) {
  Statement insert(database, "INSERT INTO record_notes (test_id, label, text) VALUES (?,?,?)");
  for (const lab::Note& note : notes)
    Binder(insert).integer(id).text_or_null(note.label).text(note.text).run();
}

void insert_guesses(SQLite::Database& database, std::int64_t id,
                    const std::vector<lab::Guess>& guesses) {
  Statement insert(
      database, "INSERT INTO guesses (test_id, what, taken, evidence, remedy) VALUES (?,?,?,?,?)");
  for (const lab::Guess& guess : guesses)
    Binder(insert)
        .integer(id)
        .text(guess.what)
        .text(guess.taken)
        .text(guess.evidence)
        .text(guess.remedy)
        .run();
}

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

void insert_instant(SQLite::Database& database, std::int64_t id, std::string_view kind,
                    const std::optional<lab::Instant>& instant) {
  if (!instant) return;
  Statement insert(database, "INSERT INTO instants VALUES (?,?,?,?,?,?,?,?)");
  Binder(insert)
      .integer(id)
      .text(kind)
      .integer(instant->reading)
      .number(instant->time_s)
      .number(instant->axial_strain)
      .si(instant->q_pa, "kPa")
      .si(instant->p_eff_pa, "kPa")
      .si(instant->pore_pressure_pa, "kPa")
      .run();
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

void bind_moment(Binder& row, const std::optional<lab::Moment>& moment) {
  row.integer(moment ? std::optional(moment->reading) : std::nullopt)
      .number(moment ? moment->time_s : std::nullopt);
}

void bind_interval(Binder& row, const std::optional<lab::StressInterval>& of) {
  const lab::StressInterval known = of.value_or(lab::StressInterval{});
  const auto if_known = [&](double value) { return of ? std::optional(value) : std::nullopt; };
  row.number(if_known(known.eta.low)).number(if_known(known.eta.high));
  for (const lab::Interval& interval : {known.q_pa, known.p_eff_pa})
    row.si(if_known(interval.low), "kPa").si(if_known(interval.high), "kPa");
}

void insert_verdict(SQLite::Database& database, std::int64_t id, const lab::Collapse& c) {
  Statement insert(database,
                   "INSERT INTO verdicts VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
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
  bind_moment(row, c.noticed);
  row.run();
  insert_instant(database, id, "onset", c.onset);
  Statement criterion(database,
                      "INSERT INTO criteria (test_id, name, detected, reading, time_s, eta, "
                      "evidence, noticed_reading, noticed_time_s) VALUES (?,?,?,?,?,?,?,?,?)");
  for (const lab::Criterion& found : c.criteria) {
    Binder of_criterion(criterion);
    of_criterion.integer(id)
        .text(found.name)
        .integer(found.detected)
        .integer(found.reading)
        .number(found.time_s)
        .number(found.eta)
        .text_or_null(found.evidence);
    bind_moment(of_criterion, found.noticed);
    of_criterion.run();
  }
}

/// All but its reading.
void bind_outlook(Binder& row, const lab::Outlook& outlook) {
  const auto& left = outlook.left;
  row.number(outlook.time_s)
      .number(outlook.eta)
      .number(outlook.eta_low)
      .number(outlook.eta_high)
      .text_or_null(left ? heading(left->quantity) : std::string())
      .number(left ? std::optional(in_field_units(*left)) : std::nullopt)
      .number(left ? left->time_s : std::nullopt);
}

void insert_outlook(SQLite::Database& database, std::int64_t id, lab::WarningLevel level,
                    const std::optional<lab::Outlook>& outlook) {
  if (!outlook) return;
  Statement insert(database, "INSERT INTO outlooks VALUES (?,?,?,?,?,?,?,?,?,?)");
  Binder row(insert);
  row.integer(id).text(to_string(level)).integer(outlook->reading);
  bind_outlook(row, *outlook);
  row.run();
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
  Statement insert(database, "INSERT INTO run_aways VALUES (?,?,?,?,?,?,?,?,?,?)");
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

/// One if the file of this test is already in the database, else none.
std::vector<lab::Warning> warnings_of_earlier_readings(SQLite::Database& database,
                                                       std::int64_t id) {
  Statement earlier(database,
                    "SELECT e.id, e.name, count(*) OVER () FROM tests e JOIN tests t "
                    "ON t.digest = e.digest WHERE t.id = ?1 AND e.id <> ?1 "
                    "ORDER BY e.id DESC LIMIT 1");
  earlier.bind(1, id);
  if (!earlier.executeStep()) return {};
  const auto more = earlier.getColumn(2).getInt64() - 1;
  return {{0, fmt::format(
                  "the same file was read before as test {} {}{}; statistics count it once, "
                  "by its latest complete reading",
                  earlier.getColumn(0).getInt64(), lab::excerpt(earlier.getColumn(1).getString()),
                  more > 0 ? fmt::format(" and {} more", more) : std::string())}};
}

}  // namespace

std::int64_t insert_test(SQLite::Database& database, const lab::RecordHeader& header,
                         const std::string& stored_at) {
  Statement insert(
      database,
      "INSERT INTO tests (name, origin, programme, source, dialect, digest, seed, status, "
      "stored_at, has_time, columns) VALUES (?,?,?,?,?,?,?,'running',?,?,?)");
  Binder(insert)
      .text(header.name)
      .text(to_string(header.origin))
      .text_or_null(header.programme)
      .text_or_null(header.source)
      .text_or_null(header.dialect)
      .text_or_null(header.digest)
      .integer(header.seed ? std::optional(static_cast<std::int64_t>(*header.seed)) : std::nullopt)
      .text(stored_at)
      .integer(header.has_time)
      .text(column_list(header.columns))
      .run();
  const std::int64_t id = database.getLastInsertRowid();
  insert_specimen(database, id, header.specimen);
  insert_stages(database, id, header.stages);
  insert_notes(database, id, header.notes);
  insert_guesses(database, id, header.guesses);
  insert_warnings(database, id, "at_start", header.warnings);
  insert_warnings(database, id, "at_start", warnings_of_earlier_readings(database, id));
  return id;
}

void insert_sweep(SQLite::Database& database, std::int64_t test_id, const SweepMembership& sweep) {
  Statement insert(database, "INSERT INTO sweep_members VALUES (?,?,?,?,?,?)");
  int position = 0;
  for (const auto& [key, value] : sweep.values) {
    Binder row(insert);
    row.integer(test_id).text(sweep.sweep).integer(sweep.place).integer(++position).text(key);
    row.number_or_text(value).run();
  }
}

void insert_event(SQLite::Database& database, std::int64_t test_id, const lab::Event& event) {
  Statement insert(database,
                   "INSERT INTO events (test_id, reading, time_s, kind, detail, noticed_reading, "
                   "noticed_time_s) VALUES (?,?,?,?,?,?,?)");
  Binder row(insert);
  row.integer(test_id)
      .integer(event.reading)
      .number(event.time_s)
      .text(to_string(event.kind))
      .text(event.detail);
  bind_moment(row, event.noticed);
  row.run();
}

void insert_forecasts(SQLite::Database& database, std::int64_t test_id,
                      const std::vector<lab::Outlook>& forecasts) {
  if (forecasts.empty()) return;
  Statement insert(database,
                   "INSERT INTO forecast_points VALUES (?,?,?,?,?,?,?,?) "
                   // As of points of second-order work: the first at a reading stands.
                   "ON CONFLICT (id) DO NOTHING");
  for (const lab::Outlook& forecast : forecasts) {
    Binder row(insert);
    row.integer(test_id << 32 | forecast.reading);
    bind_outlook(row, forecast);
    row.run();
  }
}

void insert_summary(SQLite::Database& database, std::int64_t test_id,
                    const lab::TestSummary& summary) {
  insert_consolidation(database, test_id, summary.consolidation);
  insert_instant(database, test_id, "peak", summary.peak);
  insert_verdict(database, test_id, summary.collapse);
  insert_outlook(database, test_id, lab::WarningLevel::approaching, summary.collapse.approaching);
  insert_outlook(database, test_id, lab::WarningLevel::imminent, summary.collapse.imminent);
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

void mark_interrupted(SQLite::Database& database, std::int64_t test_id) {
  Statement mark(database,
                 "UPDATE tests SET status = 'interrupted', readings = (SELECT count(*) FROM scans "
                 "WHERE scans.id BETWEEN tests.id << 32 AND tests.id << 32 | 4294967295) "
                 "WHERE id = ?");
  Binder(mark).integer(test_id).run();
}

void remove_test(SQLite::Database& database, std::int64_t test_id) {
  for (const char* table : {"scans", "scan_details", "work_points", "forecast_points"}) {
    Statement range(database, std::string("DELETE FROM ") + table + " WHERE id BETWEEN ? AND ?");
    Binder(range).integer(test_id << 32).integer(test_id << 32 | 0xffffffff).run();
  }
  Statement test(database, "DELETE FROM tests WHERE id = ?");
  Binder(test).integer(test_id).run();
}

}  // namespace triax::db

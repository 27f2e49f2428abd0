// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/test_writer.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include "db/columns.hpp"
#include "db/test_rows.hpp"
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
  Statement insert(database, "INSERT INTO specimens VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?)");
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
      .si(s.cohesion_pa, "kPa")
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
                  "by its latest complete replay",
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

void replace_header(SQLite::Database& database, std::int64_t test_id,
                    const lab::RecordHeader& header) {
  for (const char* table : {"specimens", "stages", "record_notes", "guesses"}) {
    Statement rows(database, std::string("DELETE FROM ") + table + " WHERE test_id = ?");
    Binder(rows).integer(test_id).run();
  }
  Statement update(database, "UPDATE tests SET name = ?, programme = ? WHERE id = ?");
  Binder(update).text(header.name).text_or_null(header.programme).integer(test_id).run();
  insert_specimen(database, test_id, header.specimen);
  insert_stages(database, test_id, header.stages);
  insert_notes(database, test_id, header.notes);
  insert_guesses(database, test_id, header.guesses);
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
  Statement insert(
      database,
      "INSERT INTO events (test_id, reading, time_s, kind, detail, detected_at_reading, "
      "detected_at_time_s) VALUES (?,?,?,?,?,?,?)");
  Binder row(insert);
  row.integer(test_id)
      .integer(event.reading)
      .number(event.time_s)
      .text(to_string(event.kind))
      .text(event.detail);
  bind_moment(row, event.detected_at);
  row.run();
}

void mark_interrupted(SQLite::Database& database, std::int64_t test_id) {
  Statement mark(database,
                 "UPDATE tests SET status = 'interrupted', readings = (SELECT count(*) FROM scans "
                 "WHERE scans.id BETWEEN tests.id << 32 AND tests.id << 32 | 4294967295) "
                 "WHERE id = ?");
  Binder(mark).integer(test_id).run();
}

void remove_scans(SQLite::Database& database, std::int64_t test_id) {
  for (const char* table : {"scans", "scan_details", "work_points", "forecast_points"}) {
    Statement range(database, std::string("DELETE FROM ") + table + " WHERE id BETWEEN ? AND ?");
    Binder(range).integer(test_id << 32).integer(test_id << 32 | 0xffffffff).run();
  }
}

void remove_test(SQLite::Database& database, std::int64_t test_id) {
  remove_scans(database, test_id);
  Statement test(database, "DELETE FROM tests WHERE id = ?");
  Binder(test).integer(test_id).run();
}

}  // namespace triax::db

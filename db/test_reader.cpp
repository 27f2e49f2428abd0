// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/test_reader.hpp"

#include <sstream>

#include "db/columns.hpp"
#include "db/summary_reader.hpp"
#include "db/test_rows.hpp"

namespace triax::db {
namespace {

std::vector<lab::Quantity> quantities_in(const std::string& list) {
  std::vector<lab::Quantity> result;
  std::istringstream stream(list);
  for (std::string heading; std::getline(stream, heading, ',');)
    for (const lab::QuantityInfo& row : lab::quantities())
      if (lab::heading(row.quantity) == heading) result.push_back(row.quantity);
  return result;
}

void read_specimen(SQLite::Database& database, std::int64_t id, lab::SpecimenInfo& s) {
  for_rows(database, id,
           "SELECT height_mm, diameter_mm, void_ratio, consolidated_void_ratio, "
           "consolidated_height_mm, dry_mass_g, specific_gravity, membrane_thickness_mm, "
           "membrane_modulus_kPa, limit_friction_angle_deg, material, cohesion_kPa "
           "FROM specimens WHERE test_id = ?",
           [&](Columns& c) {
             s.height_m = c.si("mm");
             s.diameter_m = c.si("mm");
             s.void_ratio = c.number();
             s.consolidated_void_ratio = c.number();
             s.consolidated_height_m = c.si("mm");
             s.dry_mass_kg = c.si("g");
             s.specific_gravity = c.number();
             s.membrane_thickness_m = c.si("mm");
             s.membrane_modulus_pa = c.si("kPa");
             s.limit_friction_angle_rad = c.si("deg");
             s.material = c.text();
             s.cohesion_pa = c.si("kPa");
           });
}

void read_stages(SQLite::Database& database, std::int64_t id, std::vector<lab::StageInfo>& stages) {
  for_rows(
      database, id,
      "SELECT number, name, role, drainage, control, strain_path_R FROM stages WHERE test_id = ? "
      "ORDER BY rowid",
      [&](Columns& c) {
        lab::StageInfo& stage = stages.emplace_back();
        stage.number = static_cast<int>(c.integer().value_or(1));
        stage.name = c.text();
        stage.role = lab::stage_role_from(c.text()).value_or(stage.role);
        stage.drainage = lab::drainage_from(c.text()).value_or(stage.drainage);
        stage.control = lab::axial_control_from(c.text()).value_or(stage.control);
        stage.strain_path_R = c.number();
      });
}

void read_header(SQLite::Database& database, std::int64_t id, StoredTest& test) {
  lab::RecordHeader& h = test.header;
  for_rows(database, id,
           "SELECT t.id, t.name, t.origin, t.programme, t.source, t.dialect, t.digest, t.seed, "
           "s.status, s.last_sign_of_life, s.silent_s, t.stored_at, t.has_time, t.columns, "
           "s.readings, t.membrane_correction "
           "FROM tests t JOIN seen_tests s ON s.test_id = t.id WHERE t.id = ?",
           [&](Columns& c) {
             test.id = c.integer().value_or(0);
             h.name = c.text();
             h.origin = c.text() == "simulated" ? lab::Origin::simulated : lab::Origin::recorded;
             h.programme = c.text();
             h.source = c.text();
             h.dialect = c.text();
             h.digest = c.text();
             if (const auto seed = c.integer()) h.seed = static_cast<std::uint64_t>(*seed);
             test.status = status_of(c.text());
             test.sign_of_life = sign_of_life(c);
             test.stored_at = c.text();
             h.has_time = c.truth().value_or(true);
             h.columns = quantities_in(c.text());
             test.summary.readings = c.integer().value_or(0);
             test.summary.membrane_correction = c.text();
           });
  for_rows(database, id, "SELECT label, text FROM record_notes WHERE test_id = ? ORDER BY id",
           [&](Columns& c) {
             lab::Note& note = h.notes.emplace_back();
             note.label = c.text();
             note.text = c.text();
           });
  for_rows(database, id,
           "SELECT what, taken, evidence, remedy FROM guesses WHERE test_id = ? ORDER BY id",
           [&](Columns& c) {
             lab::Guess& guess = h.guesses.emplace_back();
             guess.what = c.text();
             guess.taken = c.text();
             guess.evidence = c.text();
             guess.remedy = c.text();
           });
  read_specimen(database, id, h.specimen);
  read_stages(database, id, h.stages);
}

void read_warnings(SQLite::Database& database, std::int64_t id, StoredTest& test) {
  for_rows(database, id,
           "SELECT found = 'at_start', line, text FROM warnings WHERE test_id = ? ORDER BY id",
           [&](Columns& c) {
             auto& list = *c.truth() ? test.header.warnings : test.summary.warnings;
             lab::Warning& warning = list.emplace_back();
             warning.line = c.integer().value_or(0);
             warning.text = c.text();
           });
}

void read_sweep(SQLite::Database& database, std::int64_t id, std::optional<SweepMembership>& s) {
  for_rows(database, id,
           "SELECT sweep, place, key, value FROM sweep_members WHERE test_id = ? ORDER BY position",
           [&](Columns& c) {
             if (!s) s.emplace();
             s->sweep = c.text();
             s->place = c.integer().value_or(1);
             std::string key = c.text();
             s->values.emplace_back(std::move(key), c.text());
           });
}

void read_tags(SQLite::Database& database, std::int64_t id, std::vector<std::string>& tags) {
  for_rows(database, id, "SELECT tag FROM tags WHERE test_id = ? ORDER BY tag",
           [&](Columns& c) { tags.push_back(c.text()); });
}

void read_events(SQLite::Database& database, std::int64_t id, std::vector<lab::Event>& events) {
  for_rows(
      database, id,
      "SELECT reading, time_s, kind, detail, detected_at_reading, detected_at_time_s FROM events "
      "WHERE test_id = ? ORDER BY id",
      [&](Columns& c) {
        lab::Event& event = events.emplace_back();
        event.reading = c.integer().value_or(0);
        event.time_s = c.number();
        event.kind = known(c.text(), lab::event_kind_from);
        event.detail = c.text();
        event.detected_at = read_moment(c);
      });
}

}  // namespace

std::optional<SignOfLife> sign_of_life(Columns& c) {
  std::string at = c.text();
  const auto silent_s = c.integer();
  if (at.empty()) return std::nullopt;
  return SignOfLife{std::move(at), silent_s.value_or(0)};
}

StoredTest read_test(SQLite::Database& database, std::int64_t id) {
  StoredTest test;
  read_header(database, id, test);
  if (test.id == 0) return test;
  read_warnings(database, id, test);
  read_summary(database, id, test.summary);
  read_events(database, id, test.events);
  read_sweep(database, id, test.sweep);
  read_tags(database, id, test.tags);
  test.revisions = read_revisions(database, id);
  return test;
}

}  // namespace triax::db

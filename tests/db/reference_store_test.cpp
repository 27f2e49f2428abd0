// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/reference_store.hpp"

#include <SQLiteCpp/Database.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "db/connection.hpp"
#include "db/query.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

namespace {

lab::ReferenceResult drained_result() {
  lab::ReferenceResult r;
  r.group = "TRET";
  r.line = 12;
  r.specimen = {"BH7", "12", "U", "BH7-12", "1", 6.5, 6.55};
  r.test_type = "CIDC";
  r.stage = "2";
  r.diameter_m = 0.1019;
  r.bulk_density_kg_m3 = 1.0 / 3 * 6e3;
  r.cell_pressure_pa = 500e3;
  r.pore_pressure_pa = 300e3;
  r.q_pa = 424e3;
  r.axial_strain = 0.1 + 0.2;  // no short decimal
  r.friction_angle_rad = 0.48;
  r.failure_mode = "Brittle";
  return r;
}

std::int64_t stored(const std::string& db) {
  SQLite::Database database = db::open_for_reading(db);
  return database.execAndGet("SELECT count(*) FROM reference_results").getInt64();
}

}  // namespace

TEST_CASE("reference results come back to the bit; what is unknown stays unknown") {
  const testing::TemporaryFolder folder;
  const std::string file = folder.file("t.db");
  const lab::ReferenceResult given = drained_result();
  db::store_reference_results(file, {.source = "a.ags", .project = ""}, {given});
  const auto all = db::load_reference_results(file, "a.ags");
  REQUIRE(all.size() == 1);
  const lab::ReferenceResult& r = all[0];
  CHECK(r.group == "TRET");
  CHECK(r.line == 12);
  CHECK(r.specimen == given.specimen);
  CHECK(*r.axial_strain == *given.axial_strain);
  CHECK(*r.bulk_density_kg_m3 == *given.bulk_density_kg_m3);
  CHECK(*r.friction_angle_rad == *given.friction_angle_rad);
  CHECK(*r.q_pa == 424e3);
  CHECK(r.failure_mode == "Brittle");
  CHECK_FALSE(r.height_m);
  CHECK_FALSE(r.cohesion_pa);
  CHECK(r.remarks.empty());
  SQLite::Database database = db::open_for_reading(file);
  const auto value = [&](const std::string& column) {
    return database.execAndGet("SELECT " + column + " FROM reference_results");
  };
  CHECK(value("q_kPa").getDouble() == 424);
  CHECK(value("s_eff_kPa").getDouble() == 412);
  CHECK(value("t_kPa").getDouble() == 212);
  CHECK(value("friction_angle_deg").getDouble() == Approx(27.502).margin(0.001));
  CHECK(value("remarks").isNull());
  CHECK(value("project").isNull());
}

TEST_CASE("a file that is imported again replaces its rows, and only its own") {
  const testing::TemporaryFolder folder;
  const std::string file = folder.file("t.db"), a = folder.file("a.ags"), b = folder.file("b.ags");
  const lab::ReferenceResult one = drained_result();
  db::store_reference_results(file, {a, "A"}, {one, one, one});
  db::store_reference_results(file, {b, "B"}, {one});
  CHECK(stored(file) == 4);
  const auto other_name =
      (std::filesystem::path(a).parent_path() / "." / "a.ags").string();  // the same file
  db::store_reference_results(file, {other_name, "A"}, {one, one});
  CHECK(stored(file) == 3);
  CHECK(db::load_reference_results(file, a).size() == 2);
  CHECK(db::load_reference_results(file, b).size() == 1);
  CHECK(db::load_reference_results(file, "c.ags").empty());
}

TEST_CASE("the named query lists reference results") {
  const testing::TemporaryFolder folder;
  const std::string file = folder.file("t.db");
  db::store_reference_results(file, {"a.ags", "A"}, {drained_result()});
  std::vector<std::string> names;
  std::vector<db::Value> row;
  db::query(
      file, "reference_results", [&](const auto& columns) { names = columns; },
      [&](const auto& values) { row = values; });
  REQUIRE(row.size() == names.size());
  CHECK(names[0] == "source");
  CHECK(std::get<std::string>(row[0]) == "a.ags");
  const auto q = std::ranges::find(names, "q_kPa") - names.begin();
  CHECK(std::get<double>(row.at(static_cast<std::size_t>(q))) == 424);
}

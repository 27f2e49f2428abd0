// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/report_choice.hpp"

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace triax::src;
using Ids = std::vector<std::int64_t>;

namespace {

void add_test(SQLite::Database& database, int id, const std::string& name) {
  database.exec(
      "INSERT INTO tests (id, name, origin, status, stored_at, has_time, columns) "
      "VALUES (" +
      std::to_string(id) + ", '" + name +
      "', 'simulated', 'complete', '', 1, ''); INSERT INTO specimens (test_id) VALUES "
      "(" +
      std::to_string(id) + ")");
}

void add_run(SQLite::Database& database, int id, const std::string& name) {
  database.exec(
      "INSERT INTO grain_runs (id, name, source, programme, status, recorded_at, grains, "
      "stiffness_reading, stiffness_over_diameter_MPa, tangential_ratio, friction_angle_deg, "
      "density_kg_per_m3, damping, time_step_s, porosity, void_ratio, coordination, "
      "floating_grains, grains_outside) VALUES (" +
      std::to_string(id) + ", '" + name +
      "', '', '', 'complete', '', 5, 'literal', 1, 1, 1, 1, 0, 1, 1, 1, 1, 0, 0)");
}

ReportChoice chosen(const std::vector<std::string>& names) {
  testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    SQLite::Database database = db::open_for_writing(path);
    add_test(database, 1, "CSU 26");
    add_test(database, 2, "both");
    add_run(database, 1, "dense");
    add_run(database, 2, "26");
    add_run(database, 3, "both");
    add_run(database, 4, "dense");
  }
  const db::Store tests(path);
  const db::GrainStore runs(path);
  return report_choice(tests, runs, names);
}

}  // namespace

TEST_CASE("without names all tests and all runs of grains are meant") {
  const auto [tests, runs] = chosen({});
  CHECK(tests == Ids{1, 2});
  CHECK(runs == Ids{1, 2, 3, 4});
}

TEST_CASE("a number is a test's; names are of tests or runs; grains: is a run's") {
  CHECK(chosen({"1"}).tests == Ids{1});
  CHECK(chosen({"csu_26"}).tests == Ids{1});
  CHECK(chosen({"26"}).tests == Ids{1});
  CHECK(chosen({"dense"}).runs == Ids{4});
  CHECK(chosen({"grains:1", "grains:both", "grains:26"}).runs == Ids{1, 3, 2});
  const auto [tests, runs] = chosen({"dense", "1"});
  CHECK(tests == Ids{1});
  CHECK(runs == Ids{4});
}

TEST_CASE("a name of a test and of a run says both; one of neither says so") {
  using Catch::Contains;
  CHECK_THROWS_WITH(chosen({"both"}), Contains("test 2") && Contains("grains:3"));
  CHECK_THROWS_WITH(chosen({"none"}), Contains("test 'none' does not exist"));
  CHECK_THROWS_WITH(chosen({"grains:9"}), Contains("grain run '9' does not exist"));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scan_writer.hpp"

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/scans.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

namespace {

std::vector<db::Scan> scans_of_stage(int stage, std::int64_t first, std::int64_t count) {
  std::mt19937_64 random(static_cast<std::uint64_t>(stage));
  std::vector<db::Scan> scans;
  for (std::int64_t i = first; i < first + count; ++i) {
    const auto [reading, state] = testing::raw_scan(random, i);
    scans.push_back({reading, state});
    scans.back().reading.stage = scans.back().state.stage = stage;
  }
  return scans;
}

}  // namespace

TEST_CASE("batches land under the test's key, one reference a stage, no detail for raw scans") {
  testing::TemporaryFolder folder;
  SQLite::Database database = db::open_for_writing(folder.file("t.db"));
  database.exec(
      "INSERT INTO tests (name, origin, status, stored_at, has_time, columns) "
      "VALUES ('a', 'recorded', 'running', '', 1, '')");
  const auto count = [&](const std::string& what) {
    return database.execAndGet("SELECT count(*) FROM " + what).getInt();
  };
  db::ScanWriter writer(database, 1);
  writer.write(scans_of_stage(1, 0, 500));
  writer.write(scans_of_stage(1, 500, 500));
  writer.write(scans_of_stage(2, 1000, 500));
  writer.write(std::span<const db::Scan>{});
  CHECK(count("scans") == 1500);
  CHECK(count("scans WHERE id BETWEEN (1 << 32) AND (1 << 32) + 1499") == 1500);
  CHECK(count("stage_references") == 2);
  CHECK(count("scan_details") == 0);
  CHECK(count("readings WHERE test_id = 1 AND stage = 2") == 500);

  SECTION("a number that is there already or does not fit is refused, the writer says why") {
    CHECK_THROWS_AS(writer.write(scans_of_stage(1, 10, 1)), SQLite::Exception);
    auto wrong = scans_of_stage(1, 2000, 2);
    wrong[1].reading.number = -1;
    CHECK_THROWS_AS(writer.write(wrong), lab::WorkFailed);
    CHECK(count("scans") == 1500);
  }
  SECTION("points of second-order work have the key of their reading") {
    writer.write({1200, 120.0, {-1, -2, -3, -0.5}, 0.1, 51});
    CHECK(count("second_order_work WHERE reading = 1200 AND normalised = -0.5") == 1);
    CHECK(count("second_order_work WHERE time_s = 120 AND axial_strain_path IS NULL") == 1);
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/channel_columns.hpp"

#include <SQLiteCpp/Statement.h>

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "db/recording/recorder.hpp"
#include "db/store.hpp"
#include "lab/results/quantity.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using testing::TemporaryFolder;

namespace {

using Scans = std::vector<std::pair<lab::Reading, lab::State>>;

Scans scans_of(const std::string& path, std::int64_t id) {
  Scans scans;
  db::Store(path).for_each_scan(id, 1, [&](const lab::Reading& reading, const lab::State& state) {
    scans.emplace_back(reading, state);
  });
  return scans;
}

std::int64_t record_with_channels(const std::string& path) {
  db::Recorder recorder(path);
  const lab::SessionListener listener = recorder.listener();
  listener.started(testing::raw_header("a"));
  testing::send_scans(listener, 0, 20);
  return recorder.finish({});
}

bool all_same(const Scans& a, const Scans& b) {
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < a.size(); ++i)
    equal = testing::same(a[i].first, b[i].first) && testing::same(a[i].second, b[i].second);
  return equal;
}

/// As a database was before somebody added these to the table of quantities.
void forget(SQLite::Database& database) {
  database.exec(
      "DROP VIEW readings; "
      "ALTER TABLE scans DROP COLUMN back_pressure_kPa; "
      "ALTER TABLE scan_details DROP COLUMN given_current_area_mm2; "
      "CREATE VIEW readings AS SELECT 1 AS test_id");
}

}  // namespace

TEST_CASE("every quantity has a column, that of a raw channel among the scans") {
  for (const lab::QuantityInfo& row : lab::quantities()) {
    const bool raw = lab::is_raw(row.quantity);
    const auto& names = raw ? db::scan_columns() : db::detail_columns();
    const std::string name = (raw ? "" : "given_") + lab::heading(row.quantity);
    CHECK(std::ranges::count(names, name) == 1);
  }
  CHECK(db::column_list({"a", "b"}, "s.") == "s.a, s.b");
}

TEST_CASE("a database gets the columns it lacks when it is opened, and both tests come back") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  const std::int64_t before = record_with_channels(path);
  const Scans first = scans_of(path, before);
  REQUIRE(first.size() == 20);
  {
    SQLite::Database database(path, SQLite::OPEN_READWRITE);
    forget(database);
    CHECK_FALSE(db::has_all_channels(database));
  }
  const std::int64_t after = record_with_channels(path);
  CHECK(all_same(scans_of(path, after), first));
  Scans without = first;
  for (auto& [reading, state] : without) reading[lab::Quantity::back_pressure] = lab::kMissing;
  CHECK(all_same(scans_of(path, before), without));
  SQLite::Database database = db::open_for_reading(path);
  CHECK(db::has_all_channels(database));
  CHECK(database
            .execAndGet("SELECT group_concat(test_id || ' ' || n) FROM (SELECT test_id, "
                        "count(back_pressure_kPa) AS n FROM readings GROUP BY test_id)")
            .getString() == "1 0,2 20");
}

TEST_CASE("where a database cannot be written, a column that it lacks is unknown") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  record_with_channels(path);
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  forget(database);
  CHECK(db::selected(database, "scans", "s", {"id", "back_pressure_kPa", "q_Pa"}) ==
        "s.id, NULL AS back_pressure_kPa, s.q_Pa");
  SQLite::Database reader(path, SQLite::OPEN_READONLY);
  db::show_all_channels(reader);
  CHECK(reader
            .execAndGet("SELECT count(*) || ' ' || count(back_pressure_kPa) || ' ' || "
                        "count(cell_pressure_kPa) FROM readings")
            .getString() == "20 0 20");
}

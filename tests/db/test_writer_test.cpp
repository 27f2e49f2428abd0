// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/test_writer.hpp"

#include <SQLiteCpp/Database.h>

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "db/recording/lease.hpp"
#include "db/scan_writer.hpp"
#include "db/summary_writer.hpp"
#include "db/test_reader.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

TEST_CASE("a test is running, then complete or interrupted, and leaves nothing when removed") {
  testing::TemporaryFolder folder;
  SQLite::Database database = db::open_for_writing(folder.file("t.db"));
  const auto id = db::insert_test(database, testing::raw_header("a"), "2026-01-01T00:00:00Z");
  const auto other = db::insert_test(database, testing::raw_header("b"), "2026-01-01T00:00:00Z");
  CHECK(db::read_test(database, id).status == db::TestStatus::interrupted);  // whose is it?
  db::Lease(db::Leased::test).take(database, id);
  CHECK(db::read_test(database, id).status == db::TestStatus::running);
  db::ScanWriter writer(database, id);
  const std::vector<db::Scan> scans(1);
  writer.write(scans);
  db::insert_sweep(database, id, {"s", 1, {{"seed", "1"}}});
  db::insert_event(database, id, {0, {}, lab::EventKind::limit_surface, "a sentence"});
  db::insert_forecasts(database, id, {lab::Forecast{}});
  lab::TestSummary summary;
  summary.peak = lab::Instant{};
  summary.collapse.criteria = {{}};
  summary.collapse.approaching = lab::Forecast{};
  summary.collapse.imminent = lab::Forecast{};
  summary.collapse.loss_of_control = lab::Instant{};
  summary.guard = lab::GuardOutcome{.level = lab::WarningLevel::imminent};
  summary.truth = lab::Truth{};
  summary.truth->run_aways = {{}};
  summary.checks = {{}};
  summary.warnings = {{0, "w"}};
  db::insert_summary(database, id, summary);
  database.exec("INSERT INTO tags VALUES (1, 'loose')");
  CHECK(db::read_test(database, id).status == db::TestStatus::complete);
  CHECK(db::read_test(database, id).tags == std::vector<std::string>{"loose"});
  db::mark_interrupted(database, other);
  CHECK(db::read_test(database, other).status == db::TestStatus::interrupted);
  CHECK(db::read_test(database, other).header.stages.size() == 1);

  db::remove_test(database, id);
  db::remove_test(database, other);
  SQLite::Statement tables(database, "SELECT name FROM sqlite_schema WHERE type = 'table'");
  int seen = 0;
  while (tables.executeStep()) {
    const std::string table = tables.getColumn(0).getString();
    INFO(table);
    CHECK(database.execAndGet("SELECT count(*) FROM " + table).getInt() == 0);
    ++seen;
  }
  CHECK(seen == 45);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/repair.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "db/connection.hpp"
#include "db/recording/lease.hpp"
#include "db/summary_writer.hpp"
#include "db/test_writer.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace std::chrono_literals;
using testing::TemporaryFolder;

TEST_CASE("a repair marks what is silent, with the readings that are there, and nothing else") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    SQLite::Database database = db::open_for_writing(path);
    for (const char* name : {"alive", "silent", "complete"}) {
      const auto id = db::insert_test(database, testing::raw_header(name), "now");
      db::Lease(db::Leased::test).take(database, id);
    }
    database.exec(
        "INSERT INTO scans (id, stage) VALUES (2 << 32, 1), ((2 << 32) + 1, 1);"
        "UPDATE leases SET last_sign_of_life = '2026-01-01T00:00:00Z' WHERE test_id = 2");
    db::insert_summary(database, 3, {});
  }
  std::atomic<bool> stop = false;
  std::jthread beats([&] {
    SQLite::Database database = db::open_for_writing(path);
    for (; !stop; std::this_thread::sleep_for(50ms))
      database.exec("UPDATE leases SET heartbeats = heartbeats + 1 WHERE test_id = 1");
  });
  const db::Looks looks{.between = 1s};
  const db::Repaired first = db::repair(path, looks);
  REQUIRE(first.tests.size() == 1);
  CHECK(first.tests[0].name == "silent");
  CHECK(first.tests[0].status == db::TestStatus::interrupted);
  CHECK(first.tests[0].readings == 2);
  REQUIRE(first.tests[0].sign_of_life);
  CHECK(first.tests[0].sign_of_life->at == "2026-01-01T00:00:00Z");
  CHECK(first.tests[0].sign_of_life->silent_s > 1000000);
  CHECK(db::repair(path, looks).tests.empty());
  stop = true;
  SQLite::Database database = db::open_for_reading(path);
  CHECK(database.execAndGet("SELECT group_concat(status) FROM tests").getString() ==
        "running,interrupted,complete");
  CHECK(database.execAndGet("SELECT readings FROM tests WHERE id = 2").getInt() == 2);
}

TEST_CASE("a repair brings an old schema up to date, and its runs of grains to an end") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    SQLite::Database old(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db::migrate(old, path, 12);
    old.exec(
        "INSERT INTO grain_runs (name, source, programme, status, recorded_at, grains, "
        "stiffness_reading, stiffness_over_diameter_MPa, tangential_ratio, friction_angle_deg, "
        "density_kg_per_m3, damping, time_step_s, porosity, void_ratio, coordination, "
        "floating_grains, grains_outside, writer_pid, writer_started, writer_host) VALUES "
        "('dense', '', '', 'running', '', 5, 'literal', 1, 1, 1, 1, 0, 1, 1, 1, 1, 0, 0, 1, 1, "
        "'h')");
  }
  CHECK(db::repair(path).runs == std::vector<std::string>{"run 1 'dense'"});
  SQLite::Database database(path, SQLite::OPEN_READONLY);
  CHECK(database.execAndGet("PRAGMA user_version").getInt() == db::newest_schema());
  CHECK(database.execAndGet("SELECT status FROM grain_runs").getString() == "interrupted");
  CHECK_THROWS_AS(db::repair(folder.file("none.db")), lab::BadInput);
}

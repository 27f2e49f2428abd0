// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/silent_writers.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "db/catalogue.hpp"
#include "db/connection.hpp"
#include "db/recording/repair.hpp"
#include "db/test_writer.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace std::chrono_literals;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;

namespace {

/// Test 1, whose writer beats, and test 2, whose writer is gone; both by clocks that are wrong.
struct TwoWriters {
  TwoWriters() {
    SQLite::Database database = db::open_for_writing(path);
    for (db::Lease* lease : {&alive, &gone})
      lease->take(database, db::insert_test(database, testing::raw_header("a"), "now"));
    database.exec("UPDATE leases SET last_sign_of_life = '2036-01-01T00:00:00Z'");
  }
  void beat() {
    SQLite::Database database = db::open_for_writing(path);
    while (!stop) {
      alive.renew(database);
      database.exec("UPDATE leases SET last_sign_of_life = '2036-01-01T00:00:00Z'");
      std::this_thread::sleep_for(50ms);
    }
  }
  ~TwoWriters() { stop = true; }

  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  db::Lease alive{db::Leased::test}, gone{db::Leased::test};
  std::atomic<bool> stop = false;
  std::jthread beats;
};

}  // namespace

TEST_CASE("silent_writers: a heartbeat counts, not the clock", "[threads]") {
  TwoWriters here;
  here.beats = std::jthread([&] { here.beat(); });
  CHECK(db::silent_writers({here.path}, {.between = 1s}) ==
        std::set<std::string>{here.gone.writer()});
  here.stop = true;
}

TEST_CASE("silent_writers: says that it waits, and ends when all have given a sign", "[threads]") {
  TwoWriters here;
  here.beats = std::jthread([&] { here.beat(); });
  std::string said;
  const auto began = std::chrono::steady_clock::now();
  const auto silent = db::silent_writers(
      {here.path}, {.between = 60s, .say = [&](const std::string& s) { said = s; }, .tests = {1}});
  CHECK(silent.empty());
  CHECK(std::chrono::steady_clock::now() - began < 30s);
  CHECK_THAT(said, Contains("up to 60 s"));
  here.stop = true;
}

TEST_CASE("silent_writers: does not wait where nothing is marked as running") {
  TwoWriters here;
  db::open_for_writing(here.path).exec("UPDATE tests SET status = 'interrupted'");
  CHECK(db::silent_writers({here.path}, {.between = 600s}).empty());
}

TEST_CASE("repair: leaves a test alone whose recorder is alive by another clock", "[threads]") {
  TwoWriters here;
  here.beats = std::jthread([&] { here.beat(); });
  const auto repaired = db::repair(here.path, {.between = 1s}).tests;
  here.stop = true;
  REQUIRE(repaired.size() == 1);
  CHECK(repaired[0].id == 2);
}

TEST_CASE("remove_tests: only where the writer is known to be silent") {
  TwoWriters here;
  const std::set<std::string> silent = {here.gone.writer()};
  CHECK_THROWS_WITH(db::remove_tests(here.path, {1, 2}, silent), Contains("still being recorded"));
  CHECK(db::remove_tests(here.path, {2}, silent).size() == 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Many recorders of one sweep on one database.
#include <SQLiteCpp/Database.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>

#include "db/recording/recorder.hpp"
#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using testing::TemporaryFolder;

TEST_CASE("two hundred tests of a sweep on several threads get ids in its order, one fails",
          "[threads]") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  constexpr std::int64_t kTests = 200, kBad = 77;
  db::Turns turns;
  std::atomic<std::int64_t> next = 1;
  std::atomic<int> failures = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 3; ++i)
      threads.emplace_back([&] {
        for (auto place = next++; place <= kTests; place = next++) {
          try {
            db::Recorder recorder(path);
            recorder.belongs_to({"s", place, {{"seed", std::to_string(place)}, {"word", "x"}}},
                                turns);
            const lab::SessionListener listener = recorder.listener();
            if (place == kBad) throw lab::BadInput("made to fail");
            listener.started(testing::raw_header("test " + std::to_string(place)));
            testing::send_scans(listener, 0, 200 + place % 7 * 300);
            recorder.finish({});
          } catch (...) {
            ++failures;
          }
          turns.over(place);
        }
      });
  }
  CHECK(failures == 1);
  {
    SQLite::Database database(path, SQLite::OPEN_READWRITE);
    CHECK(database.execAndGet("PRAGMA integrity_check").getString() == "ok");
  }
  const db::Store store(path);
  const auto ids = store.find({});
  REQUIRE(ids.size() == kTests - 1);
  bool in_order = true;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto place = static_cast<std::int64_t>(i) + (i + 1 < kBad ? 1 : 2);
    const db::StoredTest test = store.load(ids[i]);
    in_order = in_order && ids[i] == static_cast<std::int64_t>(i) + 1 &&
               test.status == db::TestStatus::complete && test.sweep &&
               test.sweep->place == place && test.header.name == "test " + std::to_string(place) &&
               test.sweep->values[0].second == std::to_string(place) &&
               test.sweep->values[1] == std::pair<std::string, std::string>("word", "x") &&
               store.scan_count(ids[i]) == 200 + place % 7 * 300;
  }
  CHECK(in_order);
  SQLite::Database database(path, SQLite::OPEN_READONLY);
  CHECK(database
            .execAndGet("SELECT count(*) FROM sweep_results WHERE key = 'seed' AND value < 10 "
                        "AND typeof(value) = 'integer'")
            .getInt() == 9);
}

TEST_CASE("tests of a sweep stand in its order although their ids do not", "[threads]") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  for (const auto& [name, place] : {std::pair("alone", 0), std::pair("third", 3),
                                    std::pair("first", 1), std::pair("later", 0)}) {
    db::Recorder recorder(path);
    db::Turns turns;
    for (int before = 1; before < place; ++before) turns.over(before);
    if (place > 0) recorder.belongs_to({"s", place, {{"seed", "1"}}}, turns);
    const lab::SessionListener listener = recorder.listener();
    listener.started(testing::raw_header(name));
    recorder.finish({});
  }
  CHECK(db::Store(path).find({}) == std::vector<std::int64_t>{1, 3, 2, 4});
}

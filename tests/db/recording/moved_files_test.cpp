// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of readings when the files of their database are renamed, removed or replaced.
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>

#include "db/connection.hpp"
#include "db/recording/recorder.hpp"
#include "db/recording/repair.hpp"
#include "db/recording/spool.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace std::chrono_literals;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kBatchSize = 2000;

struct Sentences {
  db::Patience patience() {
    return {.quiet = 200ms, .again = 20ms, .most = 60s, .say = [this](const std::string& s) {
              const std::lock_guard lock(mutex);
              all += s + "\n";
            }};
  }
  bool has(const std::string& words) {
    const std::lock_guard lock(mutex);
    return all.find(words) != std::string::npos;
  }
  std::mutex mutex;
  std::string all;
};

void store_small_test(const std::string& path, const std::string& name) {
  db::Recorder recorder(path);
  testing::start_test(recorder, name);
  recorder.finish({});
}

std::string with_small_test(const std::string& made) {
  fs::create_directory(made);
  store_small_test(made + "/t.db", "before");
  return made + "/t.db";
}

template <class Condition>
bool within_3_s(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + 3s;
  while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(10ms);
  return condition();
}

/// Whether the newest test of the database has all readings, bit for bit.
bool has_all(const std::string& path, std::int64_t batches) {
  const db::Store store(path);
  std::int64_t expected = 0;
  bool same = true;
  std::mt19937_64 random;
  store.for_each_scan(
      store.find({}).back(), 1, [&](const lab::Reading& reading, const lab::State& state) {
        if (expected % kBatchSize == 0) random.seed(static_cast<std::uint64_t>(expected));
        const auto [sent, sent_state] = testing::raw_scan(random, expected++);
        same = same && testing::same(reading, sent) && testing::same(state, sent_state);
      });
  return same && expected == batches * kBatchSize;
}

/// A test under way in FOLDER/d/t.db, with one batch in the database, behind another test.
struct TestUnderWay {
  TestUnderWay() {
    listener.started(testing::raw_header("long"));
    send();
    if (!within_3_s([&] { return db::Store(path).find({}).size() == 2; }))
      throw std::runtime_error("the test did not enter the database");
  }
  void send() { testing::send_scans(listener, kBatchSize * batches++, kBatchSize); }
  bool noticed() {
    return within_3_s([&] { return said.has("renamed, removed or replaced"); });
  }
  std::int64_t finish() {
    lab::TestSummary summary;
    summary.readings = batches * kBatchSize;
    return recorder.finish(summary);
  }

  TemporaryFolder folder;
  const std::string path = with_small_test(folder.file("d"));
  Sentences said;
  db::Recorder recorder{path, said.patience()};
  lab::SessionListener listener = recorder.listener();
  std::int64_t batches = 0;
};

}  // namespace

TEST_CASE("Recorder: a database that is renamed or removed is noticed, nothing is lost",
          "[threads]") {
  for (const bool renamed : {true, false}) {
    INFO((renamed ? "renamed" : "removed"));
    TestUnderWay test;
    const std::string elsewhere = test.folder.file("e.db");
    renamed ? fs::rename(test.path, elsewhere) : void(fs::remove(test.path));
    REQUIRE(test.noticed());  // also while no reading comes
    REQUIRE(within_3_s([&] { return test.said.has("contains all readings of the test so far"); }));
    test.send();
    CHECK(within_3_s([&] { return has_all(db::spools_beside(test.path).front(), 2); }));
    CHECK_FALSE(fs::exists(test.path));  // that is the user's decision
    CHECK(test.finish() == 1);
    CHECK(has_all(test.path, 2));
    CHECK(db::Store(test.path).load(1).status == db::TestStatus::complete);
    CHECK(db::spools_beside(test.path).empty());
    CHECK(test.said.has("nothing is lost"));
    if (!renamed) continue;
    CHECK_FALSE(fs::exists(elsewhere + "-wal"));
    CHECK(db::Store(elsewhere).find({}).size() == 2);  // whole without what was left behind
    CHECK(db::Store(elsewhere).scan_count(2) == kBatchSize);
  }
}

TEST_CASE("Recorder: a database that comes back is written again", "[threads]") {
  TestUnderWay test;
  fs::rename(test.path, test.folder.file("e.db"));
  REQUIRE(test.noticed());
  test.send();
  REQUIRE(within_3_s([&] { return !db::spools_beside(test.path).empty(); }));
  fs::rename(test.folder.file("e.db"), test.path);
  CHECK(within_3_s([&] { return db::spools_beside(test.path).empty(); }));
  test.send();
  CHECK(test.finish() == 2);
  CHECK(has_all(test.path, 3));
}

TEST_CASE("Recorder: another database put in its place takes the whole test", "[threads]") {
  TestUnderWay test;
  const std::string other = test.folder.file("other.db");
  for (const char* name : {"x", "y", "z"}) store_small_test(other, name);
  fs::rename(other, test.path);
  REQUIRE(test.noticed());
  test.send();
  CHECK(test.finish() == 4);
  CHECK(has_all(test.path, 2));
  CHECK(db::Store(test.path).load(1).header.name == "x");
}

TEST_CASE("Recorder: readings stay beside what is no database, and a repair finds them",
          "[threads]") {
  TestUnderWay test;
  fs::remove(test.path);
  fs::create_directory(test.path);
  REQUIRE(test.noticed());
  test.send();
  CHECK_THROWS_WITH(test.finish(), Contains("the readings are buffered in") && Contains("repair"));
  fs::remove(test.path);
  const auto taken = db::repair(test.path, {.between = 0ms}).tests;
  REQUIRE(taken.size() == 1);
  CHECK(taken[0].readings == 2 * kBatchSize);
  CHECK(has_all(test.path, 2));
}

TEST_CASE("Recorder: waits at the end for a database that is back but locked", "[threads]") {
  TestUnderWay test;
  fs::rename(test.path, test.folder.file("e.db"));
  REQUIRE(test.noticed());
  test.send();
  REQUIRE(within_3_s([&] { return test.said.has("contains all readings of the test so far"); }));
  const std::string back = test.folder.file("back.db");
  store_small_test(back, "before");
  SQLite::Database other(back, SQLite::OPEN_READWRITE);
  other.exec("PRAGMA journal_mode = DELETE; BEGIN EXCLUSIVE");  // a lock of the file itself
  fs::rename(back, test.path);
  std::thread later([&] {
    std::this_thread::sleep_for(1s);
    other.exec("COMMIT");
  });
  CHECK_NOTHROW(test.finish());
  later.join();
  CHECK(has_all(test.path, 2));
}

TEST_CASE("Recorder: a -wal or -shm that is removed is noticed, nothing is lost", "[threads]") {
  for (const char* ending : {"-wal", "-shm"}) {
    INFO(ending);
    TestUnderWay test;
    fs::remove(test.path + ending);
    REQUIRE(test.noticed());
    test.send();
    CHECK(test.finish() == 2);
    CHECK(has_all(test.path, 2));
    CHECK(db::Store(test.path).scan_count(1) == 10);
  }
}

TEST_CASE("Recorder: follows a folder that is renamed", "[threads]") {
  TestUnderWay test;
  fs::rename(test.folder.file("d"), test.folder.file("e"));
  REQUIRE(test.noticed());
  test.send();
  CHECK(test.finish() == 2);
  CHECK_FALSE(fs::exists(test.folder.file("d")));
  CHECK(test.recorder.path() == test.folder.file("e/t.db"));
  CHECK(has_all(test.recorder.path(), 2));
}

TEST_CASE("Recorder: makes a folder again that is removed", "[threads]") {
  TestUnderWay test;
  fs::remove_all(test.folder.file("d"));
  REQUIRE(test.noticed());
  test.send();
  CHECK(test.finish() == 1);
  CHECK(has_all(test.path, 2));
}

TEST_CASE("Recorder: a database that moves while it is locked loses nothing", "[threads]") {
  TestUnderWay test;
  SQLite::Database other(test.path, SQLite::OPEN_READWRITE, 5000);
  other.exec("BEGIN IMMEDIATE");
  test.send();
  REQUIRE(within_3_s([&] { return !db::spools_beside(test.path).empty(); }));
  fs::remove(test.path);
  REQUIRE(test.noticed());
  test.send();
  CHECK(test.finish() == 1);
  CHECK(has_all(test.path, 3));
}

TEST_CASE("Recorder: bad input leaves a file alone that took the place of its own", "[threads]") {
  TestUnderWay test;
  fs::remove(test.path);
  store_small_test(test.path, "other");
  test.recorder.discard();
  CHECK(db::Store(test.path).load(1).header.name == "other");
}

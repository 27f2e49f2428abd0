// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/recorder.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <optional>
#include <thread>

#include "db/connection.hpp"
#include "db/files/folder_claim.hpp"
#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace std::chrono_literals;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;

namespace {

/// A recorder and what a session tells it, which has started.
struct Recording {
  Recording(const std::string& path, const std::string& name, db::Patience patience = {})
      : recorder(path, std::move(patience)), listener(recorder.listener()) {
    listener.started(testing::raw_header(name));
  }
  db::Recorder recorder;
  const lab::SessionListener listener;
};

std::string content(const std::string& path) {
  SQLite::Database database(path, SQLite::OPEN_READONLY);
  std::string all;
  for (const char* table : {"tests", "specimens", "stages", "stage_references", "scans",
                            "scan_details", "work_points", "events", "warnings"}) {
    SQLite::Statement rows(database, std::string("SELECT * FROM ") + table);
    while (rows.executeStep())
      for (int i = 0; i < rows.getColumnCount(); ++i) all += rows.getColumn(i).getString() + '|';
  }
  return all;
}

std::string integrity(const std::string& path) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  return database.execAndGet("PRAGMA integrity_check").getString();
}

/// The file is there before its first transaction is.
bool has_tests(const std::string& path) {
  try {
    return !db::Store(path).find({}).empty();
  } catch (const lab::BadInput&) {
    return false;
  }
}

template <class Condition>
bool comes_true(const Condition& condition) {
  for (int i = 0; i < 500; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

}  // namespace

TEST_CASE("nothing is on disk before a batch is due, and a short test is written at its end",
          "[threads]") {
  TemporaryFolder folder;
  Recording recording(folder.file("t.db"), "a");
  testing::send_scans(recording.listener, 0, 100);
  CHECK(folder.is_empty());
  CHECK(recording.recorder.finish({}) == 1);
  CHECK(db::Store(folder.file("t.db")).scan_count(1) == 100);
}

TEST_CASE("what was scanned is on disk soon although no further reading comes", "[threads]") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  Recording recording(path, "a");
  testing::send_scans(recording.listener, 0, 100);
  const auto sent = std::chrono::steady_clock::now();
  REQUIRE(comes_true([&] { return std::filesystem::exists(path) && has_tests(path); }));
  const db::Store store(path);
  CHECK(store.scan_count(1) == 100);
  CHECK(std::chrono::steady_clock::now() - sent < 5s);
  const db::StoredTest test = store.load(1);
  CHECK(test.status == db::TestStatus::running);
  CHECK(test.summary.readings == 100);
  // The same reader sees what comes later: read while written.
  testing::send_scans(recording.listener, 100, 100);
  CHECK(comes_true([&] { return store.scan_count(1) == 200; }));
  recording.recorder.finish({});
  CHECK(store.load(1).status == db::TestStatus::complete);
}

TEST_CASE("many batches arrive complete and in order", "[threads]") {
  TemporaryFolder folder;
  Recording recording(folder.file("t.db"), "a");
  constexpr std::int64_t kCount = 123457;
  testing::send_scans(recording.listener, 0, kCount);
  recording.recorder.finish({});
  const db::Store store(folder.file("t.db"));
  std::int64_t expected = 0;
  store.for_each_scan(1, 1, [&](const lab::Reading& reading, const lab::State&) {
    if (reading.number == expected) ++expected;
  });
  CHECK(expected == kCount);
}

TEST_CASE("a recorder that goes away unfinished leaves an interrupted test", "[threads]") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    Recording recording(path, "a");
    testing::send_scans(recording.listener, 0, 10);
  }
  const db::Store store(path);
  CHECK(store.load(1).status == db::TestStatus::interrupted);
  CHECK(store.load(1).summary.readings == 10);
}

TEST_CASE("discard leaves no file behind where there was none", "[threads]") {
  TemporaryFolder folder;
  for (const std::int64_t scans : {0, 10, 30000}) {
    Recording recording(folder.file("t.db"), "a");
    testing::send_scans(recording.listener, 0, scans);
    if (scans > 20000)
      REQUIRE(comes_true([&] { return std::filesystem::exists(folder.file("t.db")); }));
    recording.recorder.discard();
    CHECK(folder.is_empty());
  }
}

TEST_CASE("discard leaves the content of a database as it was") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    Recording first(path, "first");
    testing::send_scans(first.listener, 0, 50);
    first.recorder.finish({});
  }
  const std::string before = content(path);
  Recording second(path, "second");
  second.listener.happened({1, 0.1, lab::EventKind::limit_surface, "a sentence"});
  testing::send_scans(second.listener, 0, 30000);
  REQUIRE(comes_true([&] { return content(path).size() > 2 * before.size(); }));
  second.recorder.discard();
  CHECK(content(path) == before);
  CHECK(db::Store(path).find({}).size() == 1);
}

TEST_CASE("discard keeps a database that another recorder uses by now", "[threads]") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  Recording first(path, "first");
  testing::send_scans(first.listener, 0, 10000);
  REQUIRE(comes_true([&] { return std::filesystem::exists(path); }));
  Recording second(path, "second");
  testing::send_scans(second.listener, 0, 20);
  second.recorder.finish({});
  first.recorder.discard();
  const db::Store store(path);
  CHECK(store.load(store.find({"second"})[0]).status == db::TestStatus::complete);
  CHECK_THROWS_AS(store.find({"first"}), lab::BadInput);
}

TEST_CASE("a test killed at any instant keeps all but its last second and is told as such") {
  TemporaryFolder folder;
  std::mt19937 random(std::random_device{}());
  for (int round = 0; round < 4; ++round) {
    const std::string path = folder.file("t" + std::to_string(round) + ".db");
    const std::string log = path + ".log";
    const pid_t child = fork();
    if (child == 0) {
      Recording recording(path, "killed");
      std::ofstream sent(log);
      std::mt19937_64 numbers(1);
      const auto start = std::chrono::steady_clock::now();
      // Half of the rounds slowly, as an instrument scans; half as fast as it goes.
      for (std::int64_t number = 0;; ++number) {
        const auto [reading, state] = testing::raw_scan(numbers, number);
        recording.listener.scanned(reading, state);
        if (round % 2 == 0) std::this_thread::sleep_for(1ms);
        if (round % 2 == 0 || number % 1000 == 0) {
          const auto now = std::chrono::steady_clock::now() - start;
          sent << number << ' '
               << std::chrono::duration_cast<std::chrono::milliseconds>(now).count() << std::endl;
        }
      }
    }
    std::this_thread::sleep_for(1200ms + std::chrono::milliseconds(random() % 700));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);

    std::vector<std::pair<std::int64_t, int>> sent;
    std::ifstream lines(log);
    for (std::pair<std::int64_t, int> line; lines >> line.first >> line.second;)
      sent.push_back(line);
    REQUIRE(sent.size() > 10);
    std::int64_t due = 0;
    for (const auto& [number, at_ms] : sent)
      if (at_ms < sent.back().second - 1000) due = number;

    CHECK(integrity(path) == "ok");
    const db::Store store(path);
    SQLite::Database(path, SQLite::OPEN_READWRITE)
        .exec("UPDATE leases SET last_sign_of_life = datetime('now', '-1 minute')");
    CHECK(store.load(1).status == db::TestStatus::interrupted);
    std::int64_t expected = 0;
    std::mt19937_64 numbers(1);
    bool same = true;
    store.for_each_scan(1, 1, [&](const lab::Reading& reading, const lab::State& state) {
      const auto [sent_reading, sent_state] = testing::raw_scan(numbers, expected++);
      same = same && testing::same(reading, sent_reading) && testing::same(state, sent_state);
    });
    CHECK(same);
    INFO("round " << round << ": " << expected << " kept, " << due << " due");
    CHECK(expected > due);
    CHECK(store.load(1).summary.readings == expected);
  }
}

TEST_CASE("two processes record into a new database at the same time") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  const auto record = [&](const char* name) {
    Recording recording(path, name);
    testing::send_scans(recording.listener, 0, 60000);
    recording.recorder.finish({});
  };
  const pid_t child = fork();
  if (child == 0) {
    try {
      record("child");
    } catch (...) {
      _exit(1);
    }
    _exit(0);
  }
  record("parent");
  int status = -1;
  waitpid(child, &status, 0);
  CHECK(status == 0);
  const db::Store store(path);
  for (const std::int64_t id : store.find({"child", "parent"})) {
    CHECK(store.scan_count(id) == 60000);
    CHECK(store.load(id).status == db::TestStatus::complete);
  }
  CHECK(integrity(path) == "ok");
}

TEST_CASE("Recorder: a path where no database can be fails before the test", "[threads]") {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("d"));
  for (const std::string& path : {folder.file("none/t.db"), folder.file("d")})
    CHECK_THROWS_WITH(Recording(path, "a"), Contains(path));
}

TEST_CASE("Recorder: a file of another program fails at the end, and meanwhile", "[threads]") {
  TemporaryFolder folder;
  const std::string path = folder.file("text");
  std::ofstream(path) << std::string(5000, 'x');
  Recording at_end(path, "a");
  testing::send_scans(at_end.listener, 0, 10);
  CHECK_THROWS_AS(at_end.recorder.finish({}), lab::BadInput);
  CHECK_NOTHROW(at_end.recorder.discard());
  Recording meanwhile(path, "a");
  CHECK_THROWS_WITH(testing::send_scans(meanwhile.listener, 0, 200000), Contains(path));
}

TEST_CASE("a disk that stays full is reported and leaves a sound database without that test") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    Recording first(path, "first");
    testing::send_scans(first.listener, 0, 50);
    first.recorder.finish({});
  }
  // The limit on the size of files stands in for the disk.
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4'000'000, 4'000'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    int outcome = 1;
    Recording second(path, "second", {.quiet = 50ms, .again = 20ms, .most = 1s});
    try {
      testing::send_scans(second.listener, 0, 500000);
    } catch (const lab::WorkFailed&) {
      outcome = 0;
      try {
        second.recorder.discard();
      } catch (const lab::WorkFailed&) {
        outcome = 0;  // no room to write even that: what was committed stays
      }
    } catch (...) {
      outcome = 2;
    }
    _exit(outcome);
  }
  int status = -1;
  waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(integrity(path) == "ok");
  const db::Store store(path);
  CHECK(store.scan_count(1) == 50);
  CHECK(store.load(1).status == db::TestStatus::complete);
}

TEST_CASE("a recorder serves one test, which has to have begun", "[threads]") {
  TemporaryFolder folder;
  db::Recorder idle(folder.file("t.db"));
  CHECK_THROWS_AS(idle.finish({}), lab::WorkFailed);
  CHECK_NOTHROW(idle.discard());
  Recording recording(folder.file("t.db"), "a");
  CHECK_THROWS_AS(recording.listener.started(testing::raw_header("b")), lab::WorkFailed);
  recording.recorder.discard();
  CHECK(folder.is_empty());
}

TEST_CASE("a reading number beyond the key is refused") {
  TemporaryFolder folder;
  Recording recording(folder.file("t.db"), "a");
  testing::send_scans(recording.listener, 0x1'0000'0000, 1);
  CHECK_THROWS_WITH(recording.recorder.finish({}), Contains("4294967296 cannot be stored"));
}

TEST_CASE("discard keeps a new database in which another wrote, or that another is opening",
          "[threads]") {
  TemporaryFolder folder;
  for (const bool opening : {false, true}) {
    const std::string path = folder.file(opening ? "opening.db" : "written.db");
    Recording first(path, "first");
    testing::send_scans(first.listener, 0, 10000);
    REQUIRE(comes_true([&] { return std::filesystem::exists(path); }));
    std::optional<db::FolderClaim> claim;
    if (opening) {
      claim.emplace(path, db::FolderClaim::Kind::shared);
    } else {
      // Waits for the first batch; no test, but something that another program stored.
      SQLite::Database other(path, SQLite::OPEN_READWRITE, 20000);
      REQUIRE(comes_true([&] { return other.tableExists("tests"); }));
      other.exec("CREATE TABLE anothers (value INTEGER)");
    }
    first.recorder.discard();
    CHECK(std::filesystem::exists(path));
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of readings while their database takes none.
#include "db/recording/spool.hpp"

#include <SQLiteCpp/Database.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "db/catalogue.hpp"
#include "db/connection.hpp"
#include "db/recording/recorder.hpp"
#include "db/recording/repair.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace std::chrono_literals;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;

namespace {

/// Another program that holds the lock of writers.
struct ForeignLock {
  explicit ForeignLock(const std::string& path) : database(path, SQLite::OPEN_READWRITE, 5000) {
    database.exec("BEGIN IMMEDIATE");
  }
  void end() { database.exec("COMMIT"); }
  SQLite::Database database;
};

struct Said {
  db::Patience patience(std::int64_t most_bytes = std::int64_t{1} << 30) {
    return {.quiet = 50ms,
            .again = 20ms,
            .most = 60s,
            .most_bytes = most_bytes,
            .say = [this](const std::string& sentence) {
              const std::lock_guard lock(mutex);
              sentences.push_back(sentence);
            }};
  }
  std::mutex mutex;
  std::vector<std::string> sentences;
};

/// A database with one complete test.
std::string begun(const TemporaryFolder& folder) {
  const std::string path = folder.file("t.db");
  db::Recorder recorder(path);
  testing::start_test(recorder, "first");
  recorder.finish({});
  return path;
}

/// Numbers and bits of the readings of test `id`, as raw_scan() made them with seed `first` of each
/// batch of `batch`.
bool whole(const std::string& path, std::int64_t id, std::int64_t count, std::int64_t batch) {
  std::int64_t expected = 0;
  bool same = true;
  std::mt19937_64 random;
  db::Store(path).for_each_scan(id, 1, [&](const lab::Reading& reading, const lab::State& state) {
    if (expected % batch == 0) random.seed(static_cast<std::uint64_t>(expected));
    const auto [sent, sent_state] = testing::raw_scan(random, expected++);
    same = same && testing::same(reading, sent) && testing::same(state, sent_state);
  });
  return same && expected == count;
}

template <class Condition>
bool becomes_true(const Condition& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
  return condition();
}

}  // namespace

TEST_CASE("readings wait beside a database that another program locks, and all of them enter it",
          "[threads]") {
  TemporaryFolder folder;
  const std::string path = begun(folder);
  Said said;
  db::Recorder recorder(path, said.patience());
  const auto listener = recorder.listener();
  listener.started(testing::raw_header("long"));
  testing::send_scans(listener, 0, 1000);
  REQUIRE(becomes_true([&] { return db::Store(path).find({}).size() == 2; }));
  ForeignLock lock(path);
  // More than memory takes: nothing of this waits for the lock to end.
  constexpr std::int64_t kBatch = 1000, kCount = 80000;
  for (std::int64_t first = kBatch; first < kCount; first += kBatch) {
    testing::send_scans(listener, first, kBatch);
    listener.second_order_work({first, static_cast<double>(first), {1.5, 1.4, 1.3, 0.9}, 0.02, 51});
    listener.foreseen({first, {}, 0.6, 0.5, 0.7, {}});
  }
  listener.happened({40000, 4000.0, lab::EventKind::limit_surface, "q fell"});
  REQUIRE(becomes_true([&] { return !db::spools_beside(path).empty(); }));
  const std::string spool = db::spools_beside(path).front();
  // The file exists before its tables do.
  REQUIRE(becomes_true([&] {
    try {
      return db::Store(spool).scan_count(1) > 40000;
    } catch (const db::NoDatabase&) {
      return false;
    }
  }));
  CHECK(db::Store(spool).load(1).header.name == "long");
  CHECK(db::Store(path).scan_count(2) == 1000);
  std::thread frees([&] {
    std::this_thread::sleep_for(300ms);
    lock.end();
  });
  lab::TestSummary summary;
  summary.readings = kCount;
  CHECK(recorder.finish(summary) == 2);
  frees.join();
  CHECK(whole(path, 2, kCount, kBatch));
  const db::Store store(path);
  CHECK(store.load(2).status == db::TestStatus::complete);
  CHECK(store.load(2).events.size() == 1);
  const auto work = store.second_order_work(2);
  REQUIRE(work.size() == 79);
  CHECK(work.back().reading == 79000);
  REQUIRE(store.forecasts(2).size() == 79);
  CHECK(store.forecasts(2).back().reading == 79000);
  CHECK(db::spools_beside(path).empty());
  CHECK_FALSE(std::filesystem::exists(spool + "-wal"));
  REQUIRE(said.sentences.size() == 2);
  CHECK_THAT(said.sentences[0], Contains(path) && Contains("locked") && Contains("buffering"));
  CHECK_THAT(said.sentences[1], Contains("nothing is lost"));
}

TEST_CASE("a test that starts under a lock enters the database when it is free", "[threads]") {
  TemporaryFolder folder;
  const std::string path = begun(folder);
  Said said;
  ForeignLock lock(path);
  {
    db::Recorder recorder(path, said.patience());
    const auto listener = recorder.listener();
    listener.started(testing::raw_header("late"));
    testing::send_scans(listener, 0, 30000);
    REQUIRE(becomes_true([&] { return !db::spools_beside(path).empty(); }));
    lock.end();
    CHECK(recorder.finish({}) == 2);
  }
  CHECK(whole(path, 2, 30000, 30000));
  CHECK(db::spools_beside(path).empty());
}

TEST_CASE("what waits when the run is killed is taken in by a repair, once", "[threads]") {
  TemporaryFolder folder;
  const std::string path = begun(folder), link = folder.file("link.db");
  std::filesystem::create_symlink("t.db", link);
  constexpr std::int64_t kBatch = 1000, kCount = 50000;
  ForeignLock lock(path);
  const pid_t child = fork();
  if (child == 0) {
    Said said;
    db::Recorder recorder(link, said.patience());
    const auto listener = recorder.listener();
    listener.started(testing::raw_header("killed"));
    for (std::int64_t first = 0; first < kCount; first += kBatch)
      testing::send_scans(listener, first, kBatch);
    listener.happened({40000, 4000.0, lab::EventKind::limit_surface, "q fell"});
    std::this_thread::sleep_for(60s);
    _exit(0);
  }
  REQUIRE(becomes_true([&] {
    try {
      const auto spools = db::spools_beside(path);
      if (spools.empty()) return false;
      const db::Store store(spools.front());
      return store.scan_count(1) == kCount && store.load(1).events.size() == 1;
    } catch (const std::exception&) {
      return false;  // it is just being made
    }
  }));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  lock.end();
  const std::string spool = db::spools_beside(path).front();
  CHECK(db::left_waiting(path).empty());  // it may still live
  SQLite::Database(spool, SQLite::OPEN_READWRITE)
      .exec("UPDATE leases SET last_sign_of_life = datetime('now', '-1 minute')");
  for (const std::string& name : {path, link}) {
    const auto left = db::left_waiting(name);
    REQUIRE(left.size() == 1);
    CHECK(left[0].spool == spool);
    CHECK(left[0].test == "killed");
    CHECK(left[0].readings == kCount);
  }
  const auto taken = db::repair(path, {.between = 0s}).tests;
  REQUIRE(taken.size() == 1);
  CHECK(taken[0].name == "killed");
  CHECK(taken[0].readings == kCount);
  CHECK(taken[0].status == db::TestStatus::interrupted);
  CHECK(whole(path, 2, kCount, kBatch));
  CHECK(db::Store(path).load(2).events.size() == 1);
  CHECK(db::spools_beside(path).empty());
  CHECK(db::left_waiting(path).empty());
  CHECK(db::repair(path).tests.empty());
}

TEST_CASE(
    "a run killed while it made the file for what waits leaves nothing that a repair stumbles "
    "over") {
  TemporaryFolder folder;
  const std::string path = begun(folder);
  const std::string spool = path + ".waiting-0123456789abcdef";
  using Made = std::function<void()>;
  for (const Made& made : {Made([&] { std::ofstream{spool}; }),
                           Made([&] {  // before the tables were committed
                             SQLite::Database(spool, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
                                 .exec("PRAGMA page_size = 32768; PRAGMA journal_mode = WAL");
                           }),
                           Made([&] { db::open_for_writing(spool); })}) {
    made();
    REQUIRE(db::spools_beside(path).size() == 1);
    CHECK(db::repair(path).tests.empty());
    CHECK(db::spools_beside(path).empty());
    CHECK_FALSE(std::filesystem::exists(spool + "-wal"));
  }
  // A writer that lives and sets about its first batch keeps its file.
  const SQLite::Database open = db::open_for_writing(spool);
  CHECK(db::repair(path).tests.empty());
  CHECK(db::spools_beside(path).size() == 1);
}

TEST_CASE(
    "while the disk takes nothing at all the session waits, and all is stored when it is free") {
  TemporaryFolder folder;
  const std::string path = begun(folder);
  constexpr std::int64_t kBatch = 1000, kCount = 120000;
  // The limit on the size of files stands in for the disk: of the database and of what is beside
  // it.
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit full{2'000'000, limit.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    Said said;
    db::Recorder recorder(path, said.patience());
    const auto listener = recorder.listener();
    listener.started(testing::raw_header("full"));
    std::atomic<std::int64_t> sent = 0;
    std::thread session([&] {
      for (; sent < kCount; sent += kBatch) testing::send_scans(listener, sent, kBatch);
    });
    std::this_thread::sleep_for(2s);
    const bool waited = sent < kCount;  // memory is bounded
    setrlimit(RLIMIT_FSIZE, &limit);
    session.join();
    const bool stored = recorder.finish({}) == 2;
    const bool said_both = said.sentences.size() == 2;
    _exit(!waited + 2 * !stored + 4 * !said_both);
  }
  int status = -1;
  waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(whole(path, 2, kCount, kBatch));
  CHECK(db::spools_beside(path).empty());
}

TEST_CASE("a spool grows to its bound, then the session waits; patience has an end", "[threads]") {
  TemporaryFolder folder;
  const std::string path = begun(folder);
  Said said;
  db::Patience patience = said.patience(8'000'000);
  ForeignLock lock(path);
  constexpr std::int64_t kBatch = 1000, kCount = 150000;
  {
    db::Recorder recorder(path, patience);
    const auto listener = recorder.listener();
    listener.started(testing::raw_header("bounded"));
    std::atomic<std::int64_t> sent = 0;
    std::thread session([&] {
      for (; sent < kCount; sent += kBatch) testing::send_scans(listener, sent, kBatch);
    });
    std::this_thread::sleep_for(2s);
    CHECK(sent < kCount);
    REQUIRE(db::spools_beside(path).size() == 1);
    CHECK(std::filesystem::file_size(db::spools_beside(path).front()) < 8'500'000);
    lock.end();
    session.join();
    CHECK(recorder.finish({}) == 2);
  }
  CHECK(whole(path, 2, kCount, kBatch));

  ForeignLock again(path);
  for (const bool by_user : {false, true}) {
    patience = said.patience();
    if (by_user)
      patience.stop = [] { return true; };
    else
      patience.most = 0s;
    db::Recorder recorder(path, patience);
    const auto listener = recorder.listener();
    listener.started(testing::raw_header("given up"));
    testing::send_scans(listener, 0, 100);
    CHECK_THROWS_WITH(recorder.finish({}),
                      Contains("the readings are buffered in") && Contains("repair"));
    REQUIRE(db::spools_beside(path).size() == (by_user ? 2 : 1));
    CHECK(db::Store(db::spools_beside(path).front()).scan_count(1) == 100);
  }
}

TEST_CASE("bad input under a lock leaves nothing beside the database", "[threads]") {
  TemporaryFolder folder;
  const std::string path = begun(folder);
  Said said;
  ForeignLock lock(path);
  db::Recorder recorder(path, said.patience());
  const auto listener = recorder.listener();
  listener.started(testing::raw_header("bad"));
  testing::send_scans(listener, 0, 30000);
  REQUIRE(becomes_true([&] { return !db::spools_beside(path).empty(); }));
  lock.end();
  recorder.discard();
  CHECK(db::spools_beside(path).empty());
  CHECK(db::Store(path).find({}).size() == 1);
}

namespace {

/// Records into `path` as `writer`, in a process that is killed once its readings are in `where`.
template <class Where>
void kill_recorder(const std::string& path, const std::string& writer, const Where& has_readings) {
  const pid_t child = fork();
  if (child == 0) {
    Said said;
    db::Recorder recorder(path, said.patience(), writer);
    const auto listener = recorder.listener();
    listener.started(testing::raw_header("killed"));
    testing::send_scans(listener, 0, 15000);
    std::this_thread::sleep_for(60s);
    _exit(0);
  }
  const bool stored = becomes_true([&] {
    try {
      return has_readings();
    } catch (const std::exception&) {
      return false;
    }
  });
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  REQUIRE(stored);
}

}  // namespace

TEST_CASE("discard_left_test: only the test of the killed writer goes", "[threads]") {
  TemporaryFolder folder;
  const std::string path = begun(folder);
  kill_recorder(path, "0123", [&] { return db::Store(path).scan_count(2) > 0; });
  db::discard_left_test(path, "4567", true);
  CHECK(db::list_tests(path).size() == 2);
  db::discard_left_test(path, "0123", true);
  REQUIRE(db::list_tests(path).size() == 1);
  CHECK(db::list_tests(path)[0].name == "first");
  CHECK(db::Store(path).scan_count(2) == 0);
}

TEST_CASE("discard_left_test: readings beside the database go too", "[threads]") {
  TemporaryFolder folder;
  const std::string path = begun(folder);
  ForeignLock lock(path);
  kill_recorder(path, "0123", [&] { return db::Store(path + ".waiting-0123").scan_count(1) > 0; });
  lock.end();
  db::discard_left_test(path, "0123", true);
  CHECK(db::spools_beside(path).empty());
  CHECK(db::list_tests(path).size() == 1);
}

TEST_CASE("discard_left_test: a database that the writer made goes", "[threads]") {
  TemporaryFolder folder;
  const std::string path = folder.file("new.db");
  db::discard_left_test(path, "0123", false);
  CHECK(folder.is_empty());
  kill_recorder(path, "0123", [&] { return db::Store(path).scan_count(1) > 0; });
  db::discard_left_test(path, "0123", false);
  CHECK(folder.is_empty());
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader finds where SQLite cannot open the files beside a database.
#include "db/private_copy.hpp"

#include <SQLiteCpp/Database.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <functional>

#include "db/connection.hpp"
#include "db/recording/recorder.hpp"
#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using testing::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

constexpr int kRefused = 200;

/// Two tests of 100 readings in folder/share, which nobody may write: the second still in the -wal,
/// as a kill leaves it. Nobody: root would find a way, so another user reads.
struct ReadOnlyShare {
  explicit ReadOnlyShare(bool with_wal_of_second = true) {
    const std::string path = folder.file("t.db");
    for (const char* name : {"first", "second"}) {
      db::Recorder recorder(path);
      const auto listener = recorder.listener();
      if (keeps_open == nullptr && std::string(name) == "second")
        keeps_open = std::make_unique<SQLite::Database>(path, SQLite::OPEN_READWRITE);
      if (keeps_open) keeps_open->exec("SELECT count(*) FROM tests; PRAGMA wal_checkpoint");
      listener.started(testing::raw_header(name));
      testing::send_scans(listener, 0, 100);
      recorder.finish({});
    }
    fs::create_directory(share());
    for (const char* ending : {"", "-wal"})
      if (with_wal_of_second || *ending == 0) fs::copy(path + ending, share() + "/t.db" + ending);
    fs::permissions(folder.file(""), fs::perms(0755));
    fs::permissions(share(), fs::perms(0555));
  }
  ~ReadOnlyShare() { fs::permissions(share(), fs::perms(0755)); }
  std::string share() const { return folder.file("share"); }
  std::string path() const { return share() + "/t.db"; }

  TemporaryFolder folder;
  std::unique_ptr<SQLite::Database> keeps_open;  // so that the -wal stays
};

/// What `read` gives as a user without rights; kRefused where it throws BadInput.
int as_nobody(const std::function<int()>& read) {
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(255);
    try {
      _exit(read());
    } catch (const lab::BadInput&) {
      _exit(kRefused);
    } catch (...) {
      _exit(254);
    }
  }
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int readings_in(const std::string& path) {
  const db::Store store(path);
  int readings = 0;
  for (const auto id : store.find({})) readings += static_cast<int>(store.scan_count(id));
  return readings;
}

}  // namespace

TEST_CASE("what a killed program left in a -wal is read where nothing can be written") {
  const ReadOnlyShare here;
  REQUIRE(fs::file_size(here.path() + "-wal") > 0);
  SQLite::Database without("file:" + here.path() + "?immutable=1",
                           SQLite::OPEN_READONLY | SQLite::OPEN_URI);
  REQUIRE(without.execAndGet("SELECT count(*) FROM tests").getInt() == 1);
  CHECK(as_nobody([&] { return readings_in(here.path()); }) == 200);
  fs::create_symlink(here.path(), here.folder.file("link.db"));
  CHECK(as_nobody([&] { return readings_in(here.folder.file("link.db")); }) == 200);
  const std::string own = here.folder.file("temporary");  // other programs have theirs elsewhere
  fs::create_directory(own);
  fs::permissions(own, fs::perms(0777));
  CHECK(as_nobody([&] {
          setenv("TMPDIR", own.c_str(), 1);
          const auto reader = db::open_for_reading(here.path());
          return fs::is_empty(own) ? 0 : 1;
        }) == 0);
  CHECK_FALSE(fs::exists(here.path() + "-shm"));
  for (const char* ending : {"", "-wal"}) fs::permissions(here.path() + ending, fs::perms(0444));
  CHECK(as_nobody([&] { return readings_in(here.path()); }) == 200);
}

TEST_CASE("a copy that cannot be made says where it was to be, why not, and the remedy") {
  const ReadOnlyShare here;
  const auto said = [&](const std::string& word, bool limited) {
    return as_nobody([&] {
      if (limited) {
        const rlimit little{4096, 4096};
        setrlimit(RLIMIT_FSIZE, &little);
        std::signal(SIGXFSZ, SIG_IGN);
      } else {
        setenv("TMPDIR", "/no/such/folder", 1);
      }
      try {
        return readings_in(here.path());
      } catch (const lab::WorkFailed& error) {
        const std::string words = error.what();
        const bool all = words.find("is read through a temporary copy") != std::string::npos &&
                         words.find("TMPDIR") != std::string::npos &&
                         words.find(word) != std::string::npos;
        return all ? 1 : 2;
      }
    });
  };
  CHECK(said("/no/such/folder", false) == 1);
  CHECK(said("copy.db cannot be written", true) == 1);
}

TEST_CASE(
    "a database at rest is read where nothing can be written; a -wal of nobody's is refused") {
  const ReadOnlyShare here(false);
  CHECK(as_nobody([&] { return readings_in(here.path()); }) == 100);
  const ReadOnlyShare closed;
  fs::permissions(closed.path() + "-wal", fs::perms(0600));
  CHECK(as_nobody([&] { return readings_in(closed.path()); }) == (geteuid() == 0 ? kRefused : 200));
}

TEST_CASE("a transaction that was cut off is rolled back by a reader who may write nothing") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db"), share = folder.file("share");
  {
    db::Recorder recorder(path);
    const auto listener = recorder.listener();
    listener.started(testing::raw_header("a"));
    testing::send_scans(listener, 0, 100);
    recorder.finish({});
  }
  fs::create_directory(share);
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  // Without WAL, and so little room in memory that half a transaction reaches the file.
  database.exec(
      "PRAGMA journal_mode = DELETE; PRAGMA cache_size = 1; BEGIN; DELETE FROM scans; "
      "UPDATE tests SET name = 'b'; DELETE FROM leases; DELETE FROM stages; "
      "PRAGMA cache_spill = 1; UPDATE specimens SET material = hex(zeroblob(400000))");
  for (const char* ending : {"", "-journal"}) fs::copy(path + ending, share + "/t.db" + ending);
  database.exec("ROLLBACK");
  fs::permissions(folder.file(""), fs::perms(0755));
  fs::permissions(share, fs::perms(0555));
  CHECK(as_nobody([&] { return readings_in(share + "/t.db"); }) == 100);
  fs::permissions(share, fs::perms(0755));
}

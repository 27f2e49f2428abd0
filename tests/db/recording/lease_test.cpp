// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/lease.hpp"

#include <SQLiteCpp/Statement.h>

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "db/test_writer.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using testing::TemporaryFolder;

namespace {

struct Leases {
  std::string word(const std::string& sql) { return database.execAndGet(sql).getString(); }
  std::string seen(std::int64_t test) {
    return word("SELECT status FROM seen_tests WHERE test_id = " + std::to_string(test));
  }
  void sign_at(const std::string& when) {
    database.exec("UPDATE leases SET last_sign_of_life = datetime('now', '" + when + "')");
  }
  TemporaryFolder folder;
  SQLite::Database database = db::open_for_writing(folder.file("t.db"));
  std::int64_t id = db::insert_test(database, testing::raw_header("a"), "now");
  db::Lease lease{db::Leased::test};
};

}  // namespace

TEST_CASE("a test runs as long as its writer gives signs, whatever process or host that is") {
  Leases here;
  CHECK(here.seen(here.id) == "interrupted");  // of an older triax, which gave none
  here.lease.take(here.database, here.id);
  CHECK(here.seen(here.id) == "running");
  CHECK(here.lease.writer().size() == 32);
  CHECK(here.lease.writer() != db::Lease(db::Leased::test).writer());
  here.sign_at("-15 seconds");
  CHECK(here.seen(here.id) == "running");
  for (const char* when : {"-25 seconds", "-3 days", "+1 hour"}) {
    here.sign_at(when);
    CHECK(here.seen(here.id) == "interrupted");
  }
  CHECK(here.word("SELECT status FROM tests") == "running");  // nothing was written
  here.lease.renew(here.database);
  CHECK(here.seen(here.id) == "running");
  CHECK_FALSE(here.lease.is_due());
  here.lease.end(here.database);
  CHECK(here.word("SELECT count(*) FROM leases") == "0");
}

TEST_CASE("a writer that was taken for dead gets its test back; of one that was removed it hears") {
  Leases here;
  here.lease.take(here.database, here.id);
  db::mark_interrupted(here.database, here.id);
  CHECK(here.seen(here.id) == "interrupted");
  CHECK(here.word("SELECT readings FROM tests") == "0");
  here.lease.renew(here.database);
  CHECK(here.seen(here.id) == "running");
  CHECK(here.database.execAndGet("SELECT readings FROM tests").isNull());
  db::remove_test(here.database, here.id);
  CHECK(here.word("SELECT count(*) FROM leases") == "0");
  CHECK_THROWS_AS(here.lease.renew(here.database), lab::WorkFailed);
}

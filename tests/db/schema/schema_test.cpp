// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/schema/schema.hpp"

#include <sqlite3.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "db/catalogue.hpp"
#include "db/connection.hpp"
#include "db/query.hpp"
#include "db/recording/recorder.hpp"
#include "db/recording/repair.hpp"
#include "db/recording/spool.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;

namespace {

/// A database with test 1, and what another program did to it.
std::string changed_database(const TemporaryFolder& folder, const std::string& sql) {
  static int number = 0;
  const std::string path = folder.file("t" + std::to_string(++number) + ".db");
  db::Recorder recorder(path);
  testing::start_test(recorder);
  lab::TestSummary summary;
  summary.readings = 10;
  recorder.finish(summary);
  SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql);
  return path;
}

/// Opens the file in every way there is.
void open_in_all_ways(const std::string& path,
                      const std::function<void(std::function<void()>)>& is) {
  is([&] { db::open_for_reading(path); });
  is([&] { db::open_for_writing(path); });
  is([&] { db::check_there(path); });
  is([&] { db::list_tests(path); });
  is([&] { db::repair(path); });
  is([&] { db::Store{path}; });
  is([&] { db::rename_test(path, 1, "b"); });
  is([&] {
    db::query(
        path, "tests", [](const auto&) {}, [](const auto&) {});
  });
}

constexpr const char* kEndless =
    "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT ";

}  // namespace

TEST_CASE("check_schema: no trigger, view or table of another program") {
  const TemporaryFolder folder;
  const std::string endless = kEndless;
  for (const std::string& sql : std::vector<std::string>{
           "CREATE TRIGGER a AFTER INSERT ON scans BEGIN DELETE FROM scans; END",
           "CREATE TRIGGER a AFTER INSERT ON leases BEGIN DELETE FROM tests; END",
           "CREATE VIEW a AS " + endless + "i FROM n",
           "DROP VIEW seen_tests; CREATE VIEW seen_tests AS " + endless +
               "i AS test_id, '' AS test, '' AS origin, 'running' AS status, '' AS "
               "last_sign_of_life, 0 AS silent_s, 0 AS readings FROM n",
           "ALTER TABLE tests RENAME TO other; CREATE VIEW tests AS SELECT * FROM other",
           "DROP TABLE events",
           "DROP VIEW states",
           "CREATE VIRTUAL TABLE a USING fts5(b)",
           "DROP VIEW readings; CREATE TABLE Readings (test_id)",
           "CREATE UNIQUE INDEX a ON scans (q_Pa)",
           "CREATE INDEX a ON scans (abs(stage))",
           "ALTER TABLE scans ADD COLUMN a REAL DEFAULT 5",
           "ALTER TABLE scans ADD COLUMN a REAL AS (q_Pa)",
           "ALTER TABLE scans ADD COLUMN a REAL CHECK (a > 0)",
       }) {
    INFO(sql);
    const std::string path = changed_database(folder, sql);
    open_in_all_ways(path, [](const auto& open) { CHECK_THROWS_AS(open(), lab::BadInput); });
  }
}

TEST_CASE("check_schema: the message names the trigger and the way to remove it") {
  const TemporaryFolder folder;
  const std::string path = changed_database(
      folder, "CREATE TRIGGER 'a' AFTER INSERT ON scans BEGIN DELETE FROM scans; END");
  CHECK_THROWS_WITH(db::open_for_reading(path),
                    Contains(path) && Contains("trigger 'a'") && Contains("DROP TRIGGER 'a'"));
}

TEST_CASE("check_schema: tables, plain indexes and columns of the user are accepted") {
  const TemporaryFolder folder;
  const std::string path = changed_database(
      folder,
      "CREATE TABLE notes (id INTEGER PRIMARY KEY AUTOINCREMENT, test_id REFERENCES tests (id), "
      "words TEXT UNIQUE); CREATE INDEX notes_by_length ON notes (length(words)); "
      "CREATE INDEX scans_by_q ON scans (q_Pa); ALTER TABLE scans ADD COLUMN mark INTEGER; "
      "ANALYZE");
  open_in_all_ways(path, [](const auto& open) { CHECK_NOTHROW(open()); });
}

TEST_CASE("check_schema: every version is accepted, and a trigger in none") {
  for (int version = 1; version <= db::newest_schema(); ++version) {
    INFO("version " << version);
    const TemporaryFolder folder;
    const std::string path = folder.file("t.db");
    SQLite::Database old(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db::migrate(old, path, version);
    CHECK_NOTHROW(db::open_for_reading(path));
    old.exec("CREATE TRIGGER a AFTER DELETE ON tests BEGIN SELECT 1; END");
    CHECK_THROWS_AS(db::open_for_reading(path), lab::BadInput);
    CHECK_THROWS_AS(db::open_for_writing(path), lab::BadInput);
  }
}

TEST_CASE("check_schema: a view readings of another program is not used") {
  const TemporaryFolder folder;
  const std::string path =
      changed_database(folder, "DROP VIEW readings; CREATE VIEW readings AS " +
                                   std::string(kEndless) + "i AS test_id FROM n");
  std::int64_t rows = 0;
  db::query(
      path, "SELECT test_id FROM readings", [](const auto&) {}, [&](const auto&) { ++rows; });
  CHECK(rows == 10);
  db::open_for_writing(path);
  SQLite::Database raw(path, SQLite::OPEN_READONLY);
  CHECK(raw.execAndGet("SELECT count(*) FROM readings").getInt() == 10);
}

TEST_CASE("check_schema: a trigger in a file that readings wait in is refused") {
  const TemporaryFolder folder;
  const std::string path = changed_database(folder, "SELECT 1");
  const std::string spool = path + ".waiting-0123456789abcdef";
  std::filesystem::rename(
      changed_database(folder,
                       "CREATE TRIGGER a AFTER DELETE ON tests BEGIN SELECT 1; END; "
                       "UPDATE tests SET status = 'interrupted'"),
      spool);
  CHECK_THROWS_AS(db::take_in(spool, path, {}), lab::BadInput);
}

TEST_CASE("distrust_schema: a trigger that comes after the check does not run") {
  const TemporaryFolder folder;
  const std::string path = changed_database(folder, "SELECT 1");
  SQLite::Database database = db::open_for_writing(path);
  SQLite::Database(path, SQLite::OPEN_READWRITE)
      .exec("CREATE TRIGGER a AFTER INSERT ON tags BEGIN DELETE FROM tests; END");
  database.exec("INSERT INTO tags (test_id, tag) VALUES (1, 'loose')");
  CHECK(database.execAndGet("SELECT count(*) FROM tests").getInt() == 1);
  CHECK_THROWS_AS(database.exec("PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = ''"),
                  SQLite::Exception);
}

TEST_CASE("check_pages: pages that two trees share are refused before anything is written") {
  const TemporaryFolder folder;
  const std::string path = changed_database(
      folder,
      "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET rootpage = (SELECT rootpage FROM "
      "sqlite_schema WHERE name = 'events_by_test') WHERE name = 'checks_by_test'");
  const std::string copy = folder.file("copy.db");  // this process has checked the first file
  std::filesystem::copy_file(path, copy);
  CHECK_THROWS_WITH(db::open_for_writing(copy), Contains("is damaged and was not changed"));
  CHECK(db::Store(path).scan_count(1) == 10);  // what can be read is read
}

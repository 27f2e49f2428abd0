// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/catalogue.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "db/connection.hpp"
#include "db/recording/lease.hpp"
#include "db/recording/recorder.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;
using Words = std::vector<std::string>;

namespace {

/// One complete test of three scans with something in each of its tables; gives its id.
std::int64_t record(const std::string& path, const std::string& name,
                    const std::string& digest = {}) {
  db::Recorder recorder(path);
  const lab::SessionListener listener = recorder.listener();
  lab::RecordHeader header = testing::raw_header(name);
  header.digest = digest;
  header.warnings = {{1, "w"}};
  listener.started(header);
  testing::send_scans(listener, 0, 3);
  listener.happened({1, 0.5, lab::EventKind::limit_surface, "q fell"});
  listener.second_order_work({1, 0.3, {1.5, 1.4, 1.3, 0.9}, 0.02, 51});
  listener.second_order_work({1, 0.3, {1.5, 1.4, 1.3, 0.9}, 0.02, 51});  // loses no test
  lab::TestSummary summary;
  summary.peak = lab::Instant{};
  summary.collapse.kind = lab::CollapseKind::limited;
  summary.collapse.onset = lab::Instant{};
  summary.collapse.criteria = {{}};
  summary.truth = lab::Truth{};
  summary.truth->run_aways = {{}};
  summary.checks = {{}};
  summary.readings = 3;
  return recorder.finish(summary);
}

/// Rows of all tables together.
std::int64_t rows_in(const std::string& path) {
  SQLite::Database database(path);
  SQLite::Statement tables(database, "SELECT name FROM sqlite_schema WHERE type = 'table'");
  std::int64_t rows = 0;
  while (tables.executeStep())
    rows +=
        database.execAndGet("SELECT count(*) FROM " + tables.getColumn(0).getString()).getInt64();
  return rows;
}

Words names_in(const std::vector<db::ListedTest>& tests) {
  Words names;
  for (const auto& test : tests) names.push_back(test.name);
  return names;
}

void mark_running(const std::string& path, std::int64_t id) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  database.exec("UPDATE tests SET status = 'running', readings = NULL WHERE id = " +
                std::to_string(id));
  db::Lease(db::Leased::test).take(database, id);
}

}  // namespace

TEST_CASE("tests are listed oldest first, with what a line needs") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  record(path, "a", "aa");
  record(path, "b");
  record(path, "c", "aa");
  mark_running(path, 2);
  const auto tests = db::list_tests(path);
  REQUIRE(names_in(tests) == Words{"a", "b", "c"});
  CHECK(tests[0].id == 1);
  CHECK(tests[0].origin == lab::Origin::recorded);
  CHECK(tests[0].programme == "ICU");
  CHECK(tests[0].status == db::TestStatus::complete);
  CHECK(tests[0].kind == lab::CollapseKind::limited);
  CHECK(tests[0].readings == 3);
  CHECK(tests[0].stored_at.size() == 20);
  CHECK(tests[0].source == "a.csv");
  CHECK(tests[0].digest == "aa");
  CHECK_FALSE(tests[0].counted);
  CHECK(tests[1].status == db::TestStatus::running);
  CHECK(tests[1].readings == 3);  // so far
  CHECK(tests[1].digest.empty());
  CHECK(tests[1].counted);
  CHECK(tests[2].counted);
}

TEST_CASE("a file that was read before is a warning of the later test, and of no other") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  record(path, "first", "aa");
  record(path, "simulated");
  record(path, "another simulated");
  record(path, "of another file", "bb");
  record(path, "second", "aa");
  record(path, "third", "aa");
  const db::Store store(path);
  for (const std::int64_t id : {1, 2, 3, 4}) CHECK(store.load(id).header.warnings.size() == 1);
  const auto second = store.load(5).header.warnings, third = store.load(6).header.warnings;
  REQUIRE(second.size() == 2);
  CHECK(second[1].line == 0);
  CHECK_THAT(second[1].text, Contains("the same file was read before as test 1 'first';"));
  REQUIRE(third.size() == 2);
  CHECK_THAT(third[1].text,
             Contains("the same file was read before as test 5 'second' and 1 more;"));
}

TEST_CASE("a test gets another name; it must be a line of text, and the test be there") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  record(path, "a");
  CHECK(db::rename_test(path, 1, "  CSU 26 ") == "a");
  CHECK(names_in(db::list_tests(path)) == Words{"CSU 26"});
  for (const char* name : {"", "  ", "two\nlines", "\x1b[31m", "\xff"})
    CHECK_THROWS_AS(db::rename_test(path, 1, name), lab::BadInput);
  CHECK_THROWS_WITH(db::rename_test(path, 1, " "), Contains("the name is empty"));
  CHECK_THROWS_WITH(db::rename_test(path, 7, "b"), Contains("test 7 does not exist"));
  CHECK(names_in(db::list_tests(path)) == Words{"CSU 26"});
}

TEST_CASE("tags come once, in order, choose tests, and go") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  record(path, "a");
  record(path, "b");
  db::tag_test(path, 1, {"thesis", " loose ", "thesis"});
  db::tag_test(path, 1, {"loose"});
  db::tag_test(path, 2, {"dense"});
  CHECK(db::list_tests(path)[0].tags == Words{"loose", "thesis"});
  CHECK(db::Store(path).load(1).tags == Words{"loose", "thesis"});
  CHECK(names_in(db::list_tests(path, "thesis")) == Words{"a"});
  CHECK(db::list_tests(path, "thes").empty());
  db::untag_test(path, 1, {"thesis", "thesis"});
  CHECK(db::list_tests(path)[0].tags == Words{"loose"});

  CHECK_THROWS_WITH(db::untag_test(path, 1, {"loose", "lose"}),
                    Contains("test 1 has no tag 'lose'; did you mean 'loose'?"));
  CHECK_THROWS_WITH(db::tag_test(path, 1, {"good", ""}), Contains("the tag is empty"));
  CHECK_THROWS_WITH(db::tag_test(path, 3, {"good"}), Contains("test 3 does not exist"));
  CHECK_THROWS_WITH(db::untag_test(path, 3, {"good"}), Contains("test 3 does not exist"));
  CHECK(db::list_tests(path)[0].tags == Words{"loose"});
  db::untag_test(path, 1, {"loose"});
  CHECK_THROWS_WITH(db::untag_test(path, 1, {"loose"}), Contains("it has none"));
}

TEST_CASE("what is removed leaves no row in any table, and what stays is whole") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  record(path, "kept", "aa");
  db::tag_test(path, 1, {"loose"});
  const std::int64_t before = rows_in(path);
  record(path, "b", "aa");
  record(path, "c");
  db::tag_test(path, 2, {"loose", "thesis"});
  REQUIRE(rows_in(path) > before);
  const auto removed = db::remove_tests(path, {3, 2, 3});
  CHECK(names_in(removed) == Words{"b", "c"});
  CHECK(removed[0].readings == 3);
  CHECK(removed[0].tags == Words{"loose", "thesis"});
  CHECK(rows_in(path) == before);
  CHECK(db::Store(path).load(1).summary.readings == 3);
  CHECK(db::Store(path).scan_count(1) == 3);
  CHECK(db::list_tests(path)[0].counted);  // it was the later reading that counted
}

TEST_CASE("several tests are removed all or none") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  for (const char* name : {"a", "b", "c"}) record(path, name);
  mark_running(path, 3);
  const std::int64_t before = rows_in(path);
  CHECK_THROWS_WITH(db::remove_tests(path, {1, 9, 2, 8}), Contains("tests 8, 9 do not exist;"));
  CHECK(rows_in(path) == before);
  CHECK_THROWS_WITH(db::remove_tests(path, {1, 3}), Contains("test 3 'c' is still being recorded"));
  CHECK(rows_in(path) == before);
  CHECK(db::remove_tests(path, {1, 2}).size() == 2);
  CHECK(names_in(db::list_tests(path)) == Words{"c"});
}

TEST_CASE("no database is made where there is none, nor out of an empty file") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  CHECK_THROWS_WITH(db::list_tests(path), Contains("database does not exist"));
  CHECK_THROWS_WITH(db::rename_test(path, 1, "a"), Contains("database does not exist"));
  CHECK_THROWS_WITH(db::remove_tests(path, {1}), Contains("database does not exist"));
  CHECK_FALSE(std::filesystem::exists(path));
}

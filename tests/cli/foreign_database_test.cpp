// SPDX-License-Identifier: GPL-3.0-or-later
// Databases that are none, that another program changed, or that are no longer whole.
#include <SQLiteCpp/Database.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;
using Catch::Matchers::Contains;

namespace {

const std::string kRecordPath = "samples/records/icu_6.csv";

/// Calls that open a database, without their --db.
std::vector<std::string> calls_on_a_database() {
  return {"replay " + source(kRecordPath),
          "simulate " + source("samples/programmes/csu_26.toml"),
          "tests",
          "tests repair",
          "tests remove 1",
          "tests rename 1 a",
          "report",
          "report 1 --format html --output r.html",
          "query tests",
          "export --format csv --output o.csv",
          "soil",
          "probe --test 1 --material inl2/S28-general"};
}

void change(const Workplace& here, const std::string& sql) {
  SQLite::Database((here / "t.db").string(), SQLite::OPEN_READWRITE).exec(sql);
}

}  // namespace

TEST_CASE("option --db: a device or a pipe is refused at once, and nothing left beside it") {
  const Workplace here;
  REQUIRE(std::system(("mkfifo '" + (here / "pipe").string() + "'").c_str()) == 0);
  for (const std::string& call : calls_on_a_database()) {
    INFO(call);
    for (const char* path : {"/dev/full", "pipe"}) {
      const Outcome outcome = here.triax(call + " --db " + path);
      CHECK(outcome.status == 2);
      CHECK_THAT(outcome.err, Contains(path) && Contains("regular file"));
    }
  }
  for (const auto& entry : std::filesystem::directory_iterator(here / ""))
    CHECK(std::set<std::string>{"pipe", ".out", ".err"}.contains(entry.path().filename()));
}

TEST_CASE("option --db: a database with a trigger of another program is refused by every command") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source(kRecordPath) + " --db t.db").status == 0);
  change(here, "CREATE TRIGGER a AFTER INSERT ON scans BEGIN DELETE FROM tests; END");
  for (const std::string& call : calls_on_a_database()) {
    INFO(call);
    const Outcome outcome = here.triax(call + " --db t.db");
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("the trigger 'a'"));
  }
  change(here, "DROP TRIGGER a");
  CHECK_THAT(here.triax("tests --db t.db").out, Contains("ICU 6"));
}

TEST_CASE("readings that are missing from a database are reported by every reader") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source(kRecordPath) + " --db t.db").status == 0);
  change(here, "DELETE FROM scans WHERE rowid % 3 = 0");
  for (const char* call : {"tests", "query tests", "report", "soil", "calibrate inl2",
                           "probe --test 1 --material inl2/S28-general",
                           "export --format csv --output t.csv", "export --format json"})
    CHECK_THAT(here.triax(std::string(call) + " --db t.db").err,
               Contains("readings are missing from the database"));
  for (const char* call : {"report --db t.db", "report --db t.db --json"})
    CHECK_THAT(here.triax(call).out, Contains("readings are missing"));
}

TEST_CASE("export: a test without readings is not written as a record") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source(kRecordPath) + " --db t.db").status == 0);
  change(here, "DELETE FROM scans");
  const Outcome outcome = here.triax("export --db t.db --format csv --output n.csv");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("has no readings"));
  CHECK_FALSE(here.has("n.csv"));
}

TEST_CASE("query: --time-limit ends what computes without end") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source(kRecordPath) + " --db t.db").status == 0);
  const Outcome outcome = here.triax(
      "query --db t.db --time-limit 0.2 \"WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL "
      "SELECT i + 1 FROM n) SELECT count(*) FROM n\"");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("did not finish within 0.2 s"));
}

TEST_CASE("a small stack is an error of every command, not a signal") {
  const Workplace here;
  std::vector<std::string> calls = calls_on_a_database();
  for (const char* call : {"", "--version", "element", "domain", "grains", "calibrate", "run",
                           "record", "serve", "open", "materials"})
    calls.emplace_back(call);
  for (const char* kilobytes : {"32", "64", "128"})
    for (const std::string& call : calls) {
      INFO(kilobytes << " kB: " << call);
      const Outcome outcome = here.triax("--version >/dev/null && ulimit -s " +
                                         std::string(kilobytes) + " && " TRIAX_PROGRAM " " + call);
      CHECK(outcome.status == 1);
      CHECK_THAT(outcome.err, Contains("the stack is limited") && Contains("ulimit -s"));
    }
}

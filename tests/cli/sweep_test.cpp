// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps and interruptions as a user sees them.
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/cli/running.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

const std::string kIcu6 = source("samples/programmes/icu_6.toml");

}  // namespace

TEST_CASE("a sweep gives the same table and documents with one job and with two", "[slow]") {
  const Workplace here;
  const std::string sweep =
      "simulate " + kIcu6 + " --sweep seed=1:3:1 --sweep specimen.void_ratio=1.1,1.12";
  const Outcome one = here.triax(sweep + " --jobs 1 --db one.db");
  INFO(one.err);
  REQUIRE(one.status == 0);
  const Outcome two = here.triax(sweep + " --jobs 2 --db two.db");
  CHECK(one.out == two.out);
  CHECK(one.err.empty());
  CHECK(one.out.find("SIMULATED") != std::string::npos);
  CHECK(one.out.find("6 tests, 6 assessed, 6 collapses detected") != std::string::npos);

  const Outcome documents = here.triax(sweep + " --jobs 2 --db three.db --json");
  REQUIRE(documents.status == 0);
  const json all = json::parse(documents.out);
  REQUIRE(all.size() == 6);
  CHECK(all[1]["test"]["id"] == 2);
  CHECK(all[1]["test"]["name"].get<std::string>().ends_with("[seed 1, void_ratio 1.12]"));
  CHECK(all[1]["test"]["sweep"]["values"]["specimen.void_ratio"] == 1.12);
  CHECK(all[2]["test"]["seed"] == 2);
  CHECK(all[0]["collapse"]["truth"]["run_aways"].is_array());

  // The very same test as a run of its own.
  const json alone =
      json::parse(here.triax("simulate " + kIcu6 + " --sweep seed=2 --db alone.db --json").out);
  REQUIRE(alone.is_array());
  const json same = json::parse(here.triax("simulate " + kIcu6 + " --seed 2 --db s.db --json").out);
  CHECK(alone[0]["collapse"] == same["collapse"]);

  const json rows = json::parse(
      here.triax("query \"SELECT seed, value, eta FROM sweep_results WHERE key = "
                 "'specimen.void_ratio' AND value > 1.11 ORDER BY seed\" --db two.db --format json")
          .out);
  REQUIRE(rows.size() == 3);
  CHECK(rows[2]["seed"] == 3);
  CHECK(rows[2]["value"] == 1.12);
  CHECK(rows[2]["eta"].is_number());
  CHECK(json::parse(here.triax("query sweep --db two.db --format json").out).size() == 12);
}

TEST_CASE("--set changes the programme of one test and of a sweep, and the test says so") {
  const Workplace here;
  const std::string set = "simulate " + kIcu6 + " --set specimen.void_ratio=1.12 ";
  const json one = json::parse(here.triax(set + "--seed 2 --db one.db --json").out);
  CHECK(one["test"]["name"].get<std::string>().ends_with("[void_ratio 1.12]"));
  CHECK(one["warnings"].dump().find("specimen.void_ratio = 1.12 from --set") != std::string::npos);
  const json by_sweep =
      json::parse(here.triax("simulate " + kIcu6 +
                             " --sweep specimen.void_ratio=1.12 --sweep seed=2 --db two.db --json")
                      .out);
  CHECK(one["collapse"] == by_sweep[0]["collapse"]);
  const json swept = json::parse(here.triax(set + "--sweep seed=2 --db three.db --json").out);
  CHECK(swept[0]["collapse"] == one["collapse"]);
  CHECK(swept[0]["warnings"].dump().find("from --set") != std::string::npos);
  for (const std::string wrong : {"--set specimen.viod_ratio=1", "--set specimen.void_ratio",
                                  "--set seed=x", "--sweep seed=1:2:1 --set seed=3"}) {
    INFO(wrong);
    CHECK(here.triax("simulate " + kIcu6 + " " + wrong + " --db none.db").status == 2);
    CHECK_FALSE(here.has("none.db"));
  }
}

TEST_CASE("values that make no sense fail alone, a sweep that makes none fails as a whole") {
  const Workplace here;
  const Outcome mixed =
      here.triax("simulate " + kIcu6 + " --sweep specimen.void_ratio=1.1,99 --json");
  CHECK(mixed.status == 1);
  CHECK(mixed.err.find("--sweep [void_ratio 99]: ") != std::string::npos);
  CHECK(mixed.err.find("1 of 2 tests of the sweep failed") != std::string::npos);
  CHECK(json::parse(mixed.out).size() == 1);
  for (const std::string options :
       {"--sweep seed", "--sweep seed=3:1:1", "--sweep specimen.nothing=1",
        "--sweep seed=1:2:1 --seed 4", "--sweep seed=1:2:1 --record x.csv", "--jobs 2",
        "--sweep seed=1 --jobs 0", "--sweep seed=1 --sweep seed=2"}) {
    INFO(options);
    const Outcome outcome = here.triax("simulate " + kIcu6 + " " + options + " --db none.db");
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_FALSE(here.has("none.db"));
  }
}

TEST_CASE("Ctrl-C stores and judges a test as far as it went, and writes its record") {
  const Workplace here;
  const Running test(here, "simulate " + kIcu6 + " --speed 400 --record x.csv --db a.db --json");
  REQUIRE(test.reaches("a.db", "scans", 100));
  CHECK(test.end_by(SIGINT) == 1);
  CHECK(test.err().find("aborted by the operator") != std::string::npos);
  const json document = json::parse(test.out());
  CHECK(document["test"]["status"] == "complete");
  CHECK(document["test"]["readings"].get<int>() > 100);
  CHECK(document["warnings"].dump().find("aborted by the operator at ") != std::string::npos);
  const json again = json::parse(here.triax("replay x.csv --db b.db --json").out);
  CHECK(again["test"]["readings"] == document["test"]["readings"]);
}

TEST_CASE("Ctrl-C keeps the finished tests of a sweep") {
  const Workplace here;
  const Running sweep(here, "simulate " + kIcu6 + " --sweep seed=1:5000:1 --jobs 2");
  REQUIRE(sweep.reaches("triax.db", "tests WHERE status = 'complete'", 1));
  CHECK(sweep.end_by(SIGTERM) == 1);
  CHECK(sweep.err().find("stopped by the operator") != std::string::npos);
  const json tests = json::parse(
      here.triax("query \"SELECT status, count(*) AS n FROM tests GROUP BY status\" --format json")
          .out);
  REQUIRE(tests.size() == 1);
  CHECK(tests[0]["status"] == "complete");
  CHECK(tests[0]["n"].get<int>() > 1);
}

TEST_CASE(
    "a replay that is stopped keeps what it read, as interrupted, by either signal, once or "
    "twice") {
  const Workplace here;
  REQUIRE(here.triax("simulate " + kIcu6 + " --record x.csv --db a.db").status == 0);
  for (const int signal : {SIGTERM, SIGINT}) {
    const std::string database = signal == SIGTERM ? "term.db" : "int.db";
    const Running replay(here, "replay x.csv x.csv --speed 400 --db " + database);
    REQUIRE(replay.reaches(database, "scans", 50));
    CHECK(replay.end_by(signal, signal == SIGTERM ? 2 : 1) == 1);  // `timeout` sends two
    CHECK(replay.err().find("stopped by the operator") != std::string::npos);
    const json tests = json::parse(
        here.triax("query \"SELECT status, readings FROM tests\" --format json --db " + database)
            .out);
    REQUIRE(tests.size() == 1);
    CHECK(tests[0]["status"] == "interrupted");
    CHECK(tests[0]["readings"].get<int>() > 50);
  }
}

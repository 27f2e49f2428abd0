// SPDX-License-Identifier: GPL-3.0-or-later
// triax tests: what stands in a database, and what a user changes about it; a file that is read
// twice.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/cli/running.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

/// A workplace whose database holds icu_6.csv, tiny.csv and icu_6.csv under another name.
struct ThreeReplays : Workplace {
  ThreeReplays() {
    write(*this / "icu_6.csv", content(source("samples/records/icu_6.csv")));
    write(*this / "tiny.csv",
          "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n"
          "0.2,9,103\n");
    for (const char* record : {"icu_6.csv", "tiny.csv", "icu_6.csv --set test.name=again"})
      REQUIRE(triax("replay " + std::string(record)).status == 0);
  }
  json asked(const std::string& arguments) const {
    const Outcome outcome = triax(arguments);
    INFO(arguments << ": " << outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
  }
};

std::string without_times(const std::string& text) {
  const std::regex minute("\\d{4}-\\d\\d-\\d\\d([ T])\\d\\d:\\d\\d"), second("HH:MM:\\d\\dZ");
  return std::regex_replace(std::regex_replace(text, minute, "YYYY-MM-DD$1HH:MM"), second,
                            "HH:MM:SSZ");
}

}  // namespace

TEST_CASE(
    "a session with triax tests is what the golden text holds (refresh_golden.sh renews it)") {
  const ThreeReplays here;
  const std::string golden = content("tests/cli/golden/tests_session.txt");
  const std::string prompt = "$ triax ";
  std::istringstream lines(golden);
  std::string session;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(prompt, 0) != 0) continue;
    const Outcome outcome = here.triax(line.substr(prompt.size()));
    session += line + '\n' + outcome.out + outcome.err;
    if (outcome.status != 0) session += "[status " + std::to_string(outcome.status) + "]\n";
  }
  CHECK(without_times(session) == golden);
}

TEST_CASE("a file that is replayed again is told, and statistics count its later reading") {
  const ThreeReplays here;
  const json first = here.asked("report 1 --json"), again = here.asked("report again --json");
  CHECK(first["test"]["digest"] == again["test"]["digest"]);
  CHECK(first["test"]["digest"].get<std::string>().size() == 64);
  const std::string said = "the same file was read before as test 1 'ICU 6'";
  CHECK(first["warnings"].dump().find(said) == std::string::npos);
  CHECK(again["warnings"].dump().find(said) != std::string::npos);
  CHECK(here.asked("report tiny --json")["warnings"].dump().find("read before") ==
        std::string::npos);

  const json points = here.asked("query collapse_points --json");
  REQUIRE(points.size() == 1);
  CHECK(points[0]["test"] == "again");
  CHECK(here.asked("query instability_line --json")[0]["tests"] == 1);
  CHECK(here.asked("query collapses --json").size() == 3);
  REQUIRE(here.triax("report --output r.html").status == 0);
  CHECK(content(here / "r.html").find("the same file was read before as test 1") !=
        std::string::npos);

  // Without the later reading the earlier one counts again.
  REQUIRE(here.triax("tests remove 3").status == 0);
  CHECK(here.asked("query collapse_points --json")[0]["test_id"] == 1);
}

TEST_CASE("a simulated test has no digest, and its record, replayed, is a file like any other") {
  const Workplace here;
  const Outcome made =
      here.triax("simulate " + source("samples/programmes/icu_6.toml") + " --record x.csv --json");
  REQUIRE(made.status == 0);
  CHECK(json::parse(made.out)["test"]["digest"].is_null());
  const Outcome replayed = here.triax("replay x.csv --json");
  CHECK(json::parse(replayed.out)["test"]["digest"].is_string());
  CHECK(replayed.out.find("read before") == std::string::npos);
  CHECK(json::parse(here.triax("query collapse_points --json").out).size() == 2);
}

TEST_CASE("triax tests in JSON: each test that an action touched, as the list has it") {
  const ThreeReplays here;
  const json all = here.asked("tests --json");
  REQUIRE(all.size() == 3);
  CHECK(all[0]["name"] == "ICU 6");
  CHECK(all[0]["kind"] == "flow");
  CHECK(all[0]["counted"] == false);
  CHECK(all[1]["kind"].is_null());
  CHECK(all[2]["source"] == "icu_6.csv");
  CHECK(here.asked("tests rename 2 'CSU 26' --json")[0]["name"] == "CSU 26");
  CHECK(here.asked("tests tag 2 b a --json")[0]["tags"] == json::array({"a", "b"}));
  CHECK(here.asked("tests untag 2 b --json")[0]["tags"] == json::array({"a"}));
  CHECK(here.asked("tests --tag a --json")[0]["id"] == 2);
  CHECK(here.asked("tests --tag none --json").empty());
  const json shown = here.asked("tests show 2 --json");
  CHECK(shown["test"]["tags"] == json::array({"a"}));
  CHECK(shown["collapse"]["kind"].is_null());
  CHECK(here.asked("report 'CSU 26' --json")["test"]["id"] == 2);
  const json removed = here.asked("tests remove 2 1 --json");
  REQUIRE(removed.size() == 2);
  CHECK(removed[1]["name"] == "CSU 26");
  CHECK(here.asked("tests --json").size() == 1);
  CHECK(here.asked(
            "query \"SELECT count(*) AS n FROM readings WHERE test_id < 3\" --json")[0]["n"] == 0);
}

TEST_CASE("a test that is still being recorded is not removed, nor are others with it") {
  const Workplace here;
  write(here / "tiny.csv",
        "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n");
  REQUIRE(here.triax("replay tiny.csv").status == 0);
  const Running test(here, "simulate " + source("samples/programmes/icu_6.toml") + " --speed 400");
  REQUIRE(test.reaches("triax.db", "scans", 100));
  const Outcome refused = here.triax("tests remove 1 2");
  CHECK(refused.status == 2);
  CHECK(refused.err.find("test 2 'ICU 6' is still being recorded") != std::string::npos);
  CHECK(here.triax("tests tag 2 tonight").status == 0);
  CHECK(test.end_by(SIGTERM) == 1);
  CHECK(json::parse(here.triax("tests --json").out).size() == 2);
  CHECK(here.triax("tests remove 1 2").status == 0);
}

TEST_CASE("a test that waits beside the database for a repair is told by every reader") {
  const Workplace here;
  write(here / "tiny.csv",
        "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n");
  REQUIRE(here.triax("replay tiny.csv").status == 0);
  REQUIRE(here.triax("replay tiny.csv --db other.db").status == 0);
  std::filesystem::rename(here / "other.db", here / "triax.db.waiting-0123456789abcdef");
  const std::string readers[] = {"tests", "query unfinished_tests", "report", "tests --json"};
  for (const std::string& reader : readers) {
    INFO(reader);
    const Outcome told = here.triax(reader);
    CHECK(told.status == 0);
    CHECK(told.err.find("triax.db.waiting-0123456789abcdef: 'tiny' with 2 readings") !=
          std::string::npos);
    CHECK(told.err.find("`triax tests repair` stores it") != std::string::npos);
  }
  CHECK(here.triax("tests repair").out.find("tiny") != std::string::npos);
  for (const std::string& reader : readers) CHECK(here.triax(reader).err.empty());
  CHECK(json::parse(here.triax("tests --json").out).size() == 2);
}

TEST_CASE("triax tests makes no database where there is none") {
  const Workplace here;
  for (const char* command : {"tests", "tests show 1", "tests rename 1 a", "tests tag 1 a",
                              "tests untag 1 a", "tests remove 1"}) {
    const Outcome outcome = here.triax(command);
    INFO(command);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("database does not exist") != std::string::npos);
  }
  CHECK_FALSE(here.has("triax.db"));
}

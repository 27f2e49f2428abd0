// SPDX-License-Identifier: GPL-3.0-or-later
// The main job end to end: simulate, record, replay, report, query.
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/running.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

const std::string kCsu26 = source("samples/programmes/csu_26.toml");

json verdict(const json& test) {
  json v = test.at("collapse");
  v["consolidation"] = test.at("consolidation");
  v["peak"] = test.at("peak");
  v["checks"] = test.at("checks");
  return v;
}

const std::string kStates = "query \"SELECT * FROM states\" --format csv --db ";
const std::string kReadings = "query \"SELECT * FROM readings\" --format csv --db ";

}  // namespace

TEST_CASE("a simulated test and the replay of its record agree to the bit") {
  const Workplace here;
  const Outcome simulated = here.triax("simulate " + kCsu26 + " --record x.csv --db a.db --json");
  REQUIRE(simulated.status == 0);
  REQUIRE(simulated.err == "triax: wrote x.csv\n");
  const Outcome replayed = here.triax("replay x.csv --db b.db --json");
  REQUIRE(replayed.status == 0);
  const json a = json::parse(simulated.out), b = json::parse(replayed.out);
  CHECK(a["collapse"]["kind"] == "flow");
  CHECK(verdict(a) == verdict(b));
  CHECK(b["test"]["origin"] == "simulated");
  const std::string states = here.triax(kStates + "a.db").out;
  REQUIRE(states.size() > 100000);
  CHECK(states == here.triax(kStates + "b.db").out);
  CHECK(here.triax(kReadings + "a.db").out == here.triax(kReadings + "b.db").out);

  REQUIRE(here.triax("simulate " + kCsu26 + " --record again.csv --db c.db").status == 0);
  CHECK(content(here / "x.csv") == content(here / "again.csv"));
  REQUIRE(here.triax("simulate " + kCsu26 + " --seed 99 --record other.csv --db c.db").status == 0);
  CHECK(content(here / "x.csv") != content(here / "other.csv"));
  CHECK(here.triax("simulate " + kCsu26 + " --seed 98 --db c.db").err.empty());
  REQUIRE(here.triax("replay x.csv --db d.db --speed 20000").status == 0);
  CHECK(states == here.triax(kStates + "d.db").out);
}

TEST_CASE("the document holds every key of the contract, null where nothing is known") {
  const Workplace here;
  write(here / "bare.csv",
        "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n0.2,9,"
        "103\n");
  const Outcome outcome = here.triax("replay bare.csv --json");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const json d = json::parse(outcome.out);
  for (const char* key :
       {"test", "specimen", "consolidation", "peak", "collapse", "events", "checks", "warnings"})
    REQUIRE(d.contains(key));
  for (const char* key : {"id", "name", "origin", "programme", "source"})
    CHECK(d["test"].contains(key));
  for (const char* key : {"detected", "kind", "inside_limit_surface", "reading", "time_s",
                          "axial_strain", "q_kPa", "p_eff_kPa", "pore_pressure_kPa", "eta",
                          "phi_mob_deg", "second_order_work_normalised", "criteria", "truth"})
    CHECK(d["collapse"].contains(key));
  CHECK(d["collapse"]["truth"].is_null());
  CHECK(d["specimen"]["height_mm"].is_null());
  CHECK(d["collapse"]["detected"].is_null());  // three readings are too few to judge
  CHECK(d["collapse"]["kind"].is_null());
  CHECK(d["peak"]["q_kPa"].get<double>() == Approx(9));
}

TEST_CASE(
    "what would have been said when comes from the record alone, and from the database again") {
  const Workplace here;
  const std::string record = source("samples/records/icu_6.csv");
  const Outcome told = here.triax("replay " + record + " --live");
  REQUIRE(told.status == 0);
  for (const char* word : {"forecast", "approaching", "imminent", "lost", "before the onset"})
    CHECK(told.out.find(word) != std::string::npos);
  CHECK(here.triax("report --live").out == told.out);
  const json d = json::parse(here.triax("report --live --json").out);
  CHECK(d["collapse"]["kind"] == "flow");
  const json& live = d["live"];
  CHECK(live["forecasts"].get<int>() > live["forecasts_shown"].get<int>());
  CHECK(live["before_onset"]["imminent"]["readings"].get<int>() > 0);
  std::int64_t before = 0;
  for (const json& row : live["rows"]) {
    if (row["reading"].is_null()) continue;
    CHECK(row["reading"].get<std::int64_t>() >= before);
    before = row["reading"].get<std::int64_t>();
    CHECK_FALSE((row["event"].is_null() && row["forecast"].is_null()));
  }
  CHECK(here.triax("report --live --format pdf").status == 2);
}

TEST_CASE("reports are written whole, and queries cannot write") {
  const Workplace here;
  REQUIRE(here.triax("simulate " + source("samples/programmes/icu_6.toml")).status == 0);
  CHECK(here.triax("report --format html --output r.html").status == 0);
  CHECK(content(here / "r.html").find("SIMULATED") != std::string::npos);
  CHECK(here.triax("report --format pdf --output r.pdf").status == 0);
  CHECK(content(here / "r.pdf").rfind("%PDF", 0) == 0);
  CHECK(json::parse(here.triax("report --format json").out)["collapse"]["kind"] == "flow");
  CHECK(here.triax("report --format html --output /nowhere/r.html").status == 2);
  CHECK(here.triax("report 7").status == 2);
  const std::string before = content(here / "triax.db");
  for (const char* sql : {"DELETE FROM tests", "CREATE TABLE x (a)", "PRAGMA user_version = 9",
                          "ATTACH 'other.db' AS other", "VACUUM INTO 'copy.db'"}) {
    const Outcome outcome = here.triax(std::string("query \"") + sql + "\"");
    INFO(sql << ": " << outcome.err);
    CHECK(outcome.status == 2);
  }
  CHECK(content(here / "triax.db") == before);
  CHECK_FALSE(here.has("other.db"));
  CHECK_FALSE(here.has("copy.db"));
  const json points = json::parse(here.triax("query collapse_points --format json").out);
  REQUIRE(points.size() == 1);
  CHECK(points[0]["origin"] == "simulated");
}

TEST_CASE(
    "a killed test keeps what was read, passes the integrity check and is told as interrupted") {
  const Workplace here;
  const Running test(here, "simulate " + source("samples/programmes/icu_6.toml") + " --speed 400");
  REQUIRE(test.reaches("triax.db", "scans", 200));
  CHECK(test.end_by(SIGKILL) == -1);
  const auto seen = [&] {
    const json tests = json::parse(here.triax("query tests --format json").out);
    REQUIRE(tests.size() == 1);
    return tests[0]["status"].get<std::string>();
  };
  CHECK(seen() == "running");  // it may have been about to give the next sign
  CHECK(here.triax("tests show 1").out.find("running, last heartbeat") != std::string::npos);
  silence(here / "triax.db");
  const std::string before = content(here / "triax.db");
  CHECK(seen() == "interrupted");
  CHECK(here.triax("tests show 1").out.find("interrupted, no heartbeat since") !=
        std::string::npos);
  CHECK(content(here / "triax.db") == before);
  const json count = json::parse(
      here.triax("query \"SELECT count(*) AS n, max(reading) AS last FROM readings\" --format json")
          .out);
  CHECK(count[0]["n"].get<int>() > 200);
  CHECK(count[0]["n"].get<int>() == count[0]["last"].get<int>() + 1);
  CHECK(here.triax("query \"PRAGMA integrity_check\" --format csv").out.find("ok") !=
        std::string::npos);
  CHECK(here.triax("report").out.find("INTERRUPTED") != std::string::npos);
  const std::string raw = "query \"SELECT status FROM tests\" --format csv";
  CHECK(here.triax(raw).out.find("running") != std::string::npos);
  CHECK(here.triax("tests repair").out.find("test 1 'ICU 6': interrupted") == 0);
  CHECK(here.triax(raw).out.find("interrupted") != std::string::npos);
  CHECK(here.triax("tests repair").out.find("Nothing to repair") == 0);
}

TEST_CASE("the alarm is told of earlier tests by name, and the report says of which") {
  const Workplace here;
  const std::string kIcu = source("samples/programmes/icu_load.toml");
  REQUIRE(here.triax("simulate " + kIcu + " --seed 2 --db a.db").status == 0);
  const Outcome alone = here.triax("simulate " + kIcu + " --record x.csv --db b.db --json");
  REQUIRE(alone.status == 0);
  const Outcome told = here.triax("replay x.csv --db a.db --earlier 1 --json");
  INFO(told.err);
  REQUIRE(told.status == 0);
  const json a = json::parse(alone.out), b = json::parse(told.out);
  CHECK(b.at("warnings").dump().find("the alarm used earlier tests of this sand: ICU by load") !=
        std::string::npos);
  CHECK(a.at("warnings").dump().find("earlier tests") == std::string::npos);
  CHECK(verdict(a)["kind"] == verdict(b)["kind"]);
  CHECK(verdict(a)["reading"] == verdict(b)["reading"]);
  // The first forecast comes with the first readings, and lies within 0.02 of the onset.
  const std::string kFirst =
      "query \"SELECT min(reading) AS reading, eta_forecast FROM forecasts WHERE test_id = ";
  const std::string first = here.triax(kFirst + "2\" --format csv --db a.db").out;
  const std::string own = here.triax(kFirst + "1\" --format csv --db b.db").out;
  CHECK(first.find("reading,eta_forecast") == 0);
  const double onset = b.at("collapse").at("eta").get<double>();
  CHECK(std::stod(first.substr(first.rfind(',') + 1)) == Approx(onset).margin(0.02));
  CHECK(std::stod(first.substr(first.find('\n'))) < std::stod(own.substr(own.find('\n'))));
}

TEST_CASE("an earlier test that is not there, or says nothing, is refused in one line") {
  const Workplace here;
  REQUIRE(here.triax("simulate " + source("samples/programmes/control_drained_loose.toml") +
                     " --db a.db")
              .status == 0);
  const Outcome nothing =
      here.triax("simulate " + kCsu26 + " --db a.db --earlier \"drained loose\"");
  CHECK(nothing.status == 2);
  CHECK(nothing.err.find("not usable for the onset forecast") != std::string::npos);
  CHECK(here.triax("simulate " + kCsu26 + " --db a.db --earlier nobody").status == 2);
  CHECK(here.triax("simulate " + kCsu26 + " --db none.db --earlier 1").status == 2);
  const Outcome swept = here.triax("simulate " + kCsu26 + " --sweep seed=1,2 --earlier 1");
  CHECK(swept.status == 2);
  CHECK(swept.err.find("exclude each other") != std::string::npos);
}

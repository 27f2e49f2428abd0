// SPDX-License-Identifier: GPL-3.0-or-later
// triax tests set: a correction of a stored test, and what a kill leaves of it.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/running.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

json answer_of(const Workplace& here, const std::string& arguments) {
  const Outcome outcome = here.triax(arguments);
  INFO(arguments << ": " << outcome.err);
  REQUIRE(outcome.status == 0);
  return json::parse(outcome.out);
}

json without_revisions(json document) {
  document.erase("revisions");
  return document;
}

}  // namespace

TEST_CASE("tests set: gives a new revision that every command shows") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  const json before = answer_of(here, "report 1 --json");
  const Outcome set =
      here.triax("tests set 1 specimen.limit_friction_angle_deg=45 labels.borehole=B3");
  CHECK(set.status == 0);
  CHECK(set.out.find("test 1 'ICU 6' is now revision 2: ") == 0);
  CHECK(set.out.find("  labels.borehole: unknown -> B3\n") != std::string::npos);

  const json after = answer_of(here, "report 1 --json");
  CHECK(after["revisions"].size() == 1);
  CHECK(after["revisions"][0]["former_kind"] == before["collapse"]["kind"]);
  CHECK(after["collapse"] != before["collapse"]);
  CHECK(answer_of(here, "tests --json")[0]["revision"] == 2);
  CHECK(answer_of(here, "query revisions --json").size() == 2);
  CHECK(answer_of(here, "query \"SELECT * FROM counted_tests\" --json").size() == 1);
  CHECK(here.triax("tests show 1").out.find("labels.borehole unknown -> B3") != std::string::npos);
  CHECK(here.triax("report 1").out.find("Revisions") != std::string::npos);
  REQUIRE(here.triax("report 1 --output sheet.html").status == 0);
  CHECK(content(here / "sheet.html").find("B3") != std::string::npos);

  CHECK(here.triax("tests set 1 specimen.limit_friction_angle_deg= labels.borehole=").status == 0);
  CHECK(without_revisions(answer_of(here, "report 1 --json")) == before);
  CHECK(here.triax("tests set 1 labels.borehole=").out.find("nothing was changed") !=
        std::string::npos);
}

TEST_CASE("tests set: simulated tests with guard and runaway give their results again") {
  const Workplace here;
  for (const char* programme : {"icu_load_guarded", "icu_load", "icu_6", "csd_58"}) {
    INFO(programme);
    const std::string db = " --db " + std::string(programme) + ".db";
    REQUIRE(
        here.triax("simulate " + source("samples/programmes/") + programme + ".toml" + db).status ==
        0);
    const json before = answer_of(here, "report 1 --json" + db);
    REQUIRE(here.triax("tests set 1 specimen.diameter_mm=60" + db).status == 0);
    CHECK(without_revisions(answer_of(here, "report 1 --json" + db)) != before);
    REQUIRE(here.triax("tests set 1 specimen.diameter_mm=" + db).status == 0);
    CHECK(json::diff(without_revisions(answer_of(here, "report 1 --json" + db)), before).dump() ==
          "[]");
  }
}

TEST_CASE("tests set: refuses what it cannot do, and changes nothing") {
  const Workplace here;
  CHECK(here.triax("tests set 1 labels.client=A").status == 2);
  CHECK_FALSE(here.has("triax.db"));
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  const auto fails = [&](const std::string& arguments, const std::string& with) {
    const Outcome outcome = here.triax("tests set " + arguments);
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find(with) != std::string::npos);
  };
  fails("1", "tests set takes");
  fails("1 labels.client", "expected KEY=VALUE");
  fails("'ICU 6' labels.client=A", "is not the number of a test");
  fails("2 labels.client=A", "test 2 does not exist");
  fails("1 test.origin=simulated", "cannot be set");
  fails("1 specimen.hieght_mm=3", "did you mean 'specimen.height_mm'");
  CHECK(answer_of(here, "tests --json")[0]["revision"] == 1);
}

TEST_CASE("tests set: a kill at any instant leaves the old or the new revision") {
  const Workplace here;
  REQUIRE(here.triax("simulate " + source("samples/programmes/icu_6.toml")).status == 0);
  const std::string angles[2] = {"20", "40"};
  json whole[2];
  for (int i = 0; i < 2; ++i) {
    REQUIRE(here.triax("tests set 1 specimen.limit_friction_angle_deg=" + angles[i]).status == 0);
    whole[i] = without_revisions(answer_of(here, "report 1 --json"));
  }
  REQUIRE(whole[0] != whole[1]);
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(here.triax("tests set 1 specimen.limit_friction_angle_deg=20").status == 0);
  const std::chrono::duration<double, std::micro> lasts = std::chrono::steady_clock::now() - begin;
  int current = 0, killed = 0;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1.1);
  for (int trial = 0; trial < 20; ++trial) {
    const Running set(here, "tests set 1 specimen.limit_friction_angle_deg=" + angles[1 - current]);
    std::this_thread::sleep_for(
        std::chrono::microseconds(static_cast<int>(lasts.count() * part(random))));
    killed += set.end_by(SIGKILL) == -1 ? 1 : 0;
    const json found = without_revisions(answer_of(here, "report 1 --json"));
    INFO("trial " << trial);
    CHECK((found == whole[0] || found == whole[1]));
    current = found == whole[1] ? 1 : 0;
    CHECK(here.triax("query \"PRAGMA integrity_check\" --json").out.find("malformed") ==
          std::string::npos);
  }
  CHECK(killed > 0);
}

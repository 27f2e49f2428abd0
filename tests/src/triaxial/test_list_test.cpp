// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/test_list.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace triax;
using namespace triax::src;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

std::vector<db::ListedTest> two_readings_of_one_file() {
  db::ListedTest first;
  first.id = 3;
  first.name = "CSU 26";
  first.programme = "CSU";
  first.status = db::TestStatus::complete;
  first.kind = lab::CollapseKind::flow;
  first.readings = 1200;
  first.stored_at = "2026-01-02T03:04:05Z";
  first.source = "csu_26.csv";
  first.digest = "ab12";
  first.counted = false;
  first.tags = {"loose", "thesis"};
  db::ListedTest second = first;
  second.id = 12;
  second.kind.reset();
  second.origin = lab::Origin::simulated;
  second.counted = true;
  second.tags.clear();
  return {first, second};
}

}  // namespace

TEST_CASE("a line a test, no wider than the terminal") {
  auto tests = two_readings_of_one_file();
  const std::string text = test_list_text(tests);
  CHECK_THAT(text, Contains("CSU 26  recorded   CSU"));
  CHECK_THAT(text, Contains("flow"));
  CHECK_THAT(text, Contains("2026-01-02 03:04  loose, thesis"));
  CHECK_THAT(text, Contains("SIMULATED"));
  CHECK_THAT(text, Contains("not assessed"));
  CHECK_THAT(text, Contains("1 of these does not count: the file was replayed again"));
  tests.front().name = "a very long name of a test of many words, as some loggers write them out";
  std::istringstream lines(test_list_text(tests));
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  tests.front().counted = true;
  CHECK_THAT(test_list_text(tests), !Contains("count"));
}

TEST_CASE("a running and an interrupted test say so in place of a verdict") {
  auto tests = two_readings_of_one_file();
  tests[0].status = db::TestStatus::running;
  tests[1].status = db::TestStatus::interrupted;
  const std::string text = test_list_text(tests);
  CHECK_THAT(text, Contains("running"));
  CHECK_THAT(text, Contains("interrupted"));
  CHECK_THAT(text, !Contains("flow"));
}

TEST_CASE("JSON has every key, null where nothing is known") {
  auto tests = two_readings_of_one_file();
  tests[1].source.clear();
  tests[1].digest.clear();
  const json d = json::parse(test_list_json(tests));
  REQUIRE(d.size() == 2);
  CHECK(d[0]["id"] == 3);
  CHECK(d[0]["kind"] == "flow");
  CHECK(d[0]["counted"] == false);
  CHECK(d[0]["digest"] == "ab12");
  CHECK(d[0]["tags"] == json::array({"loose", "thesis"}));
  CHECK(d[0]["stored_at"] == "2026-01-02T03:04:05Z");
  CHECK(d[1]["kind"].is_null());
  CHECK(d[1]["source"].is_null());
  CHECK(d[1]["digest"].is_null());
  CHECK(d[1]["tags"].empty());
  CHECK(test_list_json({}) == "[]\n");
}

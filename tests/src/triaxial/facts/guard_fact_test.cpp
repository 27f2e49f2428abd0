// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/guard_fact.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "src/triaxial/json_report.hpp"
#include "src/triaxial/text_report.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using Catch::Contains;

namespace {

lab::GuardOutcome outcome() {
  lab::GuardOutcome guard;
  guard.level = lab::WarningLevel::imminent;
  guard.done = "switched to displacement at 0.05 mm/min";
  guard.at = {
      .reading = 1522, .time_s = 3044.0, .axial_strain = 0.00283, .q_pa = 41.95e3, .p_eff_pa = {}};
  guard.second_order_work_normalised = 0.335;
  guard.last_axial_strain = 0.02283;
  return guard;
}

}  // namespace

TEST_CASE("a guard is told with what the test came to, with it and without it") {
  lab::GuardOutcome guard = outcome();
  const auto alone = src::guard_lines(guard);
  REQUIRE(alone.size() == 2);
  CHECK(alone[0] ==
        "on imminent: switched to displacement at 0.05 mm/min; axial strain 0.283 %, q 41.95 "
        "kPa, normalised second-order work 0.335, at reading 1522, 50.7 min");
  CHECK(alone[1] == "axial strain 2.283 % at the end");
  guard.without = {.kind = lab::CollapseKind::flow,
                   .last_axial_strain = 0.168,
                   .lost = lab::Moment{1578, 3156.0}};
  const auto both = src::guard_lines(guard);
  REQUIRE(both.size() == 3);
  CHECK(both[2] ==
        "without it (same programme and seed): axial strain 16.800 % at the end, runaway after "
        "reading 1578, 52.6 min, collapse: flow");
}

TEST_CASE("reports and documents carry the guard, null where none acted") {
  auto test = src::test::simulated_test();
  CHECK(src::text_report({test}).find("Intervention") == std::string::npos);
  CHECK(nlohmann::json::parse(src::json_report({test}))["guard"].is_null());
  test.stored.summary.guard = outcome();
  CHECK_THAT(src::text_report({test}),
             Contains("Intervention") && Contains("on imminent: switched"));
  auto guard = nlohmann::json::parse(src::json_report({test}))["guard"];
  CHECK(guard["level"] == "imminent");
  CHECK(guard["reading"] == 1522);
  CHECK(guard["q_kPa"] == Approx(41.95));
  CHECK(guard["axial_strain"] == 0.00283);
  CHECK(guard["last_axial_strain"] == 0.02283);
  CHECK(guard["second_order_work_normalised"] == 0.335);
  CHECK(guard["without"].is_null());
  test.stored.summary.guard->without = {.kind = lab::CollapseKind::flow,
                                        .last_axial_strain = 0.168,
                                        .lost = lab::Moment{1578, 3156.0}};
  guard = nlohmann::json::parse(src::json_report({test}))["guard"];
  CHECK(guard["without"]["kind"] == "flow");
  CHECK(guard["without"]["axial_strain"] == 0.168);
  CHECK(guard["without"]["lost"]["reading"] == 1578);
}

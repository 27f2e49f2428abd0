// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/collapse_points.hpp"

#include <catch2/catch.hpp>

#include "src/study/triaxial/test_result.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

TEST_CASE("each collapse is a point, and one line through the origin fits them") {
  const auto found =
      collapse_points({sample::flow_test(), sample::simulated_test(), sample::stable_test()});
  REQUIRE(found.points.size() == 2);
  CHECK(found.points[0].test == "L<oose> 1");
  CHECK(found.points[0].programme == "ICU");
  CHECK_FALSE(found.points[0].simulated);
  CHECK(found.points[1].stress.p_pa == 200e3);
  CHECK(found.points[1].simulated);
  REQUIRE(found.instability_lines.size() == 1);
  CHECK(found.instability_lines[0] == Approx((60.0 * 100 + 110 * 200) / (100 * 100 + 200 * 200.0)));
  CHECK(found.origin.tests == 2);
  CHECK(found.origin.simulated == std::vector<std::string>{"sim-26"});
}

TEST_CASE("a failure on the limit surface is no collapse point, nor is a test without a verdict") {
  auto surface = sample::flow_test();
  surface.stored.summary.collapse.kind = lab::CollapseKind::none;
  auto unjudged = sample::flow_test();
  unjudged.stored.summary.collapse.judged = false;
  const auto found = collapse_points({surface, unjudged, sample::interrupted_test()});
  CHECK(found.points.empty());
  CHECK(found.instability_lines.empty());
  CHECK(found.limit_stress_ratios.empty());
}

TEST_CASE("a file that was read twice is one point, that of the later reading") {
  std::vector<TestResult> tests(3, sample::flow_test());
  for (std::size_t i = 0; i < tests.size(); ++i)
    tests[i].stored.id = static_cast<std::int64_t>(i + 1);
  tests[0].stored.header.digest = tests[1].stored.header.digest = "ab12";
  tests[0].stored.summary.collapse.limit_stress_ratio = 1.4;
  tests[0].stored.summary.collapse.onset->q_pa = 1;
  const auto found = collapse_points(tests);
  REQUIRE(found.points.size() == 2);
  CHECK(found.points[0].stress.q_pa == 60e3);
  REQUIRE(found.instability_lines.size() == 1);
  CHECK(found.instability_lines[0] == Approx(0.6));
  CHECK(found.limit_stress_ratios == std::vector<double>{1.25});
  CHECK(found.origin.tests == 2);
}

TEST_CASE("collapse_points: a limit with cohesion is no line through the origin") {
  std::vector<TestResult> tests(1, sample::flow_test());
  tests[0].stored.summary.collapse.limit_intercept_pa = 20e3;
  CHECK(collapse_points(tests).limit_stress_ratios.empty());
}

TEST_CASE("limits rise, and those that print alike are one; a type without a name is other") {
  std::vector<TestResult> tests(3, sample::flow_test());
  tests[0].stored.summary.collapse.limit_stress_ratio = 1.301;
  tests[1].stored.summary.collapse.limit_stress_ratio = 1.2;
  tests[2].stored.summary.collapse.limit_stress_ratio = 1.299;
  tests[2].stored.header.programme.clear();
  const auto found = collapse_points(tests);
  CHECK(found.limit_stress_ratios == std::vector<double>{1.2, 1.301});
  CHECK(found.points[2].programme == "other");
}

TEST_CASE("extension has a line of its own: its points do not turn that of compression") {
  auto extension = sample::flow_test();
  auto& onset = *extension.stored.summary.collapse.onset;
  onset.q_pa = -0.4 * *onset.p_eff_pa;
  const auto both = collapse_points({sample::flow_test(), extension});
  REQUIRE(both.instability_lines.size() == 2);
  CHECK(both.instability_lines[0] ==
        collapse_points({sample::flow_test()}).instability_lines.front());
  CHECK(both.instability_lines[1] == Approx(-0.4));
  CHECK(collapse_points({extension}).instability_lines == std::vector{both.instability_lines[1]});
}

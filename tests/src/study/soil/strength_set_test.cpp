// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/strength_set.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::study;

namespace {

MohrCircle circle(double minor, double major) { return {0, "", major, minor}; }

}  // namespace

TEST_CASE("Circles that touch one line have its cohesion and friction angle") {
  // c' 10 kPa, phi' 30 degrees: K 3, A = 2 c' sqrt(3).
  const double a = 20 * std::sqrt(3.0);
  const auto set = strength_set({circle(50, 150 + a), circle(100, 300 + a), circle(200, 600 + a)},
                                FailureCriterion::peak_deviator_stress);
  REQUIRE(set);
  CHECK(set->cohesion_kPa.value == Approx(10));
  CHECK(set->friction_angle_deg.value == Approx(30));
  CHECK_FALSE(set->friction_angle_without_cohesion_deg);
}

// Three consolidated drained specimens (ISO 17892-9, ASTM D7181), worked by hand. At the peak:
//
//   sigma3' 100, 200, 400 kPa    q 250, 452, 900 kPa    sigma1' 350, 652, 1300 kPa
//
// Weights 1/sigma1'^2, over that of the second: w = 3.470237, 1, 0.251541, their sum 4.721778.
//   mean sigma3' = (347.0237 + 200 + 100.6163)/4.721778 = 137.1602
//   mean sigma1' = (1214.5829 + 652 + 327.0031)/4.721778 = 464.5678
//   Sxx = 3.470237 * 37.1602^2 + 62.8398^2 + 0.251541 * 262.8398^2 = 26118.46
//   Sxy = 14774.06 + 11778.20 + 55234.55 = 81786.81
//   K = 3.131379,  A = 464.5678 - 3.131379 * 137.1602 = 35.0672 kPa
//   sin phi' = 2.131379/4.131379, phi' = 31.058 degrees;  c' = 35.0672/(2 * 1.769570) = 9.908 kPa
// The residuals are less than 2 % of the strength together, so that no scatter is added (0.81 < 1).
TEST_CASE("Three drained specimens worked by hand") {
  const auto set = strength_set({circle(100, 350), circle(200, 652), circle(400, 1300)},
                                FailureCriterion::peak_deviator_stress);
  REQUIRE(set);
  CHECK(set->line.b == Approx(3.131379).epsilon(2e-6));
  CHECK(set->line.a == Approx(35.0672).epsilon(2e-5));
  CHECK(set->friction_angle_deg.value == Approx(31.058).epsilon(1e-4));
  CHECK(set->cohesion_kPa.value == Approx(9.908).epsilon(2e-4));
  // One degree of freedom: t is 12.7, and the set says little of c'.
  CHECK(set->cohesion_kPa.high - set->cohesion_kPa.value ==
        Approx(12.7062 * set->cohesion_kPa.error).epsilon(1e-4));
}

// Three consolidated undrained specimens (ASTM D4767) at the largest stress ratio: effective
// stresses at failure p' 90, 150, 260 kPa and q 120, 195, 330 kPa; sigma3' = p' - q/3 = 50, 85, 150
// and sigma1' = sigma3' + q = 170, 280, 480 kPa, which lie on sigma1' = 3.1 sigma3' + 15 within 1.5
// kPa.
TEST_CASE("Three undrained specimens by their effective stresses") {
  std::vector<MohrCircle> circles;
  for (const auto& [p, q] :
       {std::pair(90.0, 120.0), std::pair(150.0, 195.0), std::pair(260.0, 330.0)}) {
    TestPoint failure;
    failure.p_eff_kPa = p;
    failure.q_kPa = q;
    circles.push_back(circle_of(failure, false));
  }
  CHECK(circles[0].minor_kPa == Approx(50));
  CHECK(circles[2].major_kPa == Approx(480));
  const auto set = strength_set(circles, FailureCriterion::peak_stress_ratio);
  REQUIRE(set);
  CHECK(set->line.b == Approx(3.1).epsilon(0.01));
  CHECK(set->friction_angle_deg.value == Approx(30.8).epsilon(0.01));
}

TEST_CASE("Two specimens, or three at one pressure, are no set") {
  CHECK_FALSE(strength_set({circle(100, 350), circle(200, 640)}, FailureCriterion::axial_strain));
  CHECK_FALSE(strength_set({circle(100, 350), circle(100, 340), circle(100, 345)},
                           FailureCriterion::axial_strain));
}

TEST_CASE("Failure at the critical state is its means, and none where none was reached") {
  TestPoints test;
  test.end = TestPoint{};
  test.critical.kind = CriticalKind::reached;
  test.critical.log_p.value = std::log(120.0);
  test.critical.eta.value = 1.2;
  const auto failed = failure_of(test, FailureCriterion::critical_state, 0.15);
  REQUIRE(failed);
  CHECK(failed->p_eff_kPa == Approx(120));
  CHECK(failed->q_kPa == Approx(144));
  test.critical.kind = CriticalKind::none;
  CHECK_FALSE(failure_of(test, FailureCriterion::critical_state, 0.15));
  CHECK(failure_criterion("critical-state") == FailureCriterion::critical_state);
}

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
//   sigma3' 100, 200, 400 kPa    q 250, 440, 900 kPa    sigma1' 350, 640, 1300 kPa
//
// Weights 1/sigma1'^2, over that of the second: w = 3.343673, 1, 0.242367, their sum 4.586040.
//   mean sigma3' = (334.3673 + 200 + 96.9468)/4.586040     = 137.6599
//   mean sigma1' = (1170.2857 + 640 + 315.0769)/4.586040   = 463.4420
//   Sxx = 3.343673 * 37.6599^2 + 62.3401^2 + 0.242367 * 262.3401^2                     = 25308.78
//   Sxy = 3.343673 * 37.6599 * 113.4420 + 62.3401 * 176.5580 + 0.242367 * 262.3401 * 836.5580
//       = 14284.89 + 11006.64 + 53190.50                                               = 78482.03
//   K = 3.100980,  A = 463.4420 - 3.100980 * 137.6599 = 36.5614 kPa
//   sin phi' = 2.100980/4.100980, phi' = 30.818 degrees;  c' = 36.5614/(2 * 1.760960) = 10.381 kPa
TEST_CASE("Three drained specimens worked by hand") {
  const auto set = strength_set({circle(100, 350), circle(200, 640), circle(400, 1300)},
                                FailureCriterion::peak_deviator_stress);
  REQUIRE(set);
  CHECK(set->line.b == Approx(3.100980).epsilon(2e-5));
  CHECK(set->line.a == Approx(36.5614).epsilon(2e-4));
  CHECK(set->friction_angle_deg.value == Approx(30.818).epsilon(1e-4));
  CHECK(set->cohesion_kPa.value == Approx(10.381).epsilon(2e-4));
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

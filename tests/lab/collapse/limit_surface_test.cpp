// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/limit_surface.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "lab/measured/assessment_limits.hpp"
#include "lab/results/summary.hpp"
#include "sim/mechanics/axisymmetric.hpp"

using namespace triax;
using namespace triax::lab;

namespace {

constexpr double kP = 100e3;  ///< p' at which stress ratios are asked for

SpecimenInfo with_cohesion(double cohesion_pa, double angle_deg) {
  SpecimenInfo specimen;
  specimen.cohesion_pa = cohesion_pa;
  specimen.limit_friction_angle_rad = sim::radians(angle_deg);
  return specimen;
}

}  // namespace

TEST_CASE("a given friction angle is the limit, in compression and in extension") {
  SpecimenInfo specimen;
  specimen.limit_friction_angle_rad = sim::radians(32);
  LimitSurface given(specimen);
  given.add(1, 250e3, 100e3);  // what the test mobilised does not matter then
  CHECK(*given.stress_ratio() == Approx(1.2872).epsilon(1e-4));
  CHECK(given.inside(1.20 * kP, kP, 5) == true);
  CHECK(given.inside(1.25 * kP, kP, 5) == false);
  CHECK(given.inside(-0.85 * kP, kP, 5) == true);  // 6 sin φ/(3 + sin φ) = 0.9008
  CHECK(given.inside(-0.88 * kP, kP, 5) == false);
}

TEST_CASE("without one the ratio at which a specimen fell excuses nothing") {
  LimitSurface own({});
  CHECK_FALSE(own.stress_ratio());
  CHECK_FALSE(own.inside(0.5 * kP, kP, 5));
  for (int i = 0; i < 100; ++i) own.add(i, 1e3 * i, 140e3);  // to η = 0.71, the largest
  CHECK(*own.stress_ratio() == Approx(0.707).margin(1e-3));
  CHECK_FALSE(own.inside(0.70 * kP, kP, 98));
  CHECK_FALSE(own.went_beyond(0.70 * kP, kP));
}

TEST_CASE("LimitSurface: the largest ratio of a test is no limit to be inside of") {
  LimitSurface own({});
  own.add(10, 70e3, 100e3);
  CHECK_FALSE(own.went_beyond(0.7 * kP, kP));
  own.add(200, 13e3, 10e3);
  CHECK(own.went_beyond(0.7 * kP, kP));
  CHECK_FALSE(own.inside(0.7 * kP, kP, 10));
  CHECK_THAT(own.source(false),
             Catch::Contains("unknown: no friction angle is given, and the 32.3°"));
}

TEST_CASE("LimitSurface: a path along a ratio does not put a lower onset inside") {
  LimitSurface own({});
  for (int i = 0; i <= 100; ++i) own.add(i, 1.35 * 1e3 * (100 + i), 1e3 * (100 + i));
  CHECK(own.went_beyond(0.7 * kP, kP));
  CHECK_FALSE(own.inside(0.7 * kP, kP, 100));
}

TEST_CASE("a path that had walked along its largest ratio before knew its limit") {
  LimitSurface own({});
  for (int i = 0; i <= 100; ++i) own.add(i, 1.35 * 1e3 * (100 + i), 1e3 * (100 + i));
  CHECK(own.inside(1.34 * kP, kP, 100) == false);
  CHECK(own.source(true) == "largest stress ratio of this test, at which the specimen failed");
  CHECK_FALSE(own.inside(1.34 * kP, kP, 15));  // not yet: q had grown by less than a fifth
}

TEST_CASE("a ratio that falls at the same p' was a limit; one that is lost with p' was not") {
  LimitSurface clay({}), sand({});
  for (int i = 0; i <= 100; ++i) {
    clay.add(i, 0.9e3 * i, 40e3);
    sand.add(i, 0.9e3 * i, 160e3);
  }
  CHECK_FALSE(clay.inside(2.25 * kP, kP, 100));
  clay.add(150, 75e3, 41e3);
  CHECK(clay.inside(2.25 * kP, kP, 100) == false);
  sand.add(101, 10e3, 40e3);  // fell within a reading: q and p' are gone
  CHECK_FALSE(sand.inside(0.56 * kP, kP, 100));
}

TEST_CASE("noise near p' = 0 sets no limit") {
  LimitSurface own({});
  own.add(1, 138e3, 100e3);
  own.add(2, 2.5e3, 1e3);
  CHECK(*own.stress_ratio() == Approx(1.38));
}

TEST_CASE("stresses that are not known, and p' of 0 or below, leave the limit as it was") {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  LimitSurface own({});
  own.add(1, kNone, 100e3);
  own.add(2, 100e3, kNone);
  own.add(3, 100e3, 0);
  own.add(4, 0, 0);
  own.add(5, 100e3, -50e3);
  CHECK_FALSE(own.stress_ratio());
  own.add(6, 90e3, 100e3);
  own.add(7, kNone, kNone);
  CHECK(*own.stress_ratio() == Approx(0.9));
}

TEST_CASE("how far below the limit a ratio lies is known where the limit was given") {
  SpecimenInfo specimen;
  specimen.limit_friction_angle_rad = sim::radians(32);
  const LimitSurface given(specimen);
  CHECK(given.below(0.6436 * kP, kP) == Approx(0.5).epsilon(1e-3));
  CHECK(given.below(-0.9008 * kP, kP) == Approx(0).margin(1e-3));
  LimitSurface own({});
  own.add(1, 100e3, 100e3);
  CHECK(own.below(0.9 * kP, kP) == 1);
}

TEST_CASE("LimitSurface: cohesion adds k to M p', in compression and in extension") {
  // sin 30° = 1/2: M = 6/5 and k = 6 c cos 30°/2.5; in extension 6/7 and 6 c cos 30°/3.5.
  const LimitSurface limit(with_cohesion(25e3, 30));
  const double k = 6 * 25e3 * std::sqrt(0.75) / 2.5, k_extension = 6 * 25e3 * std::sqrt(0.75) / 3.5;
  CHECK(*limit.stress_ratio() == Approx(1.2));
  CHECK(*limit.intercept_pa() == Approx(k));
  CHECK(limit.below(1.2 * 80e3 + k, 80e3) == Approx(0).margin(1e-12));
  CHECK(limit.below(-(80e3 * 6 / 7 + k_extension), 80e3) == Approx(0).margin(1e-12));
  CHECK(limit.inside(0.96 * (1.2 * 80e3 + k), 80e3, 5) == false);
  CHECK(limit.inside(0.94 * (1.2 * 80e3 + k), 80e3, 5) == true);
  CHECK(limit.source(true) == kGivenLimitWithCohesion);
  CHECK_FALSE(LimitSurface(with_cohesion(0, 30)).intercept_pa());
}

TEST_CASE("LimitSurface: the mobilised angle is that of Mohr's circle") {
  // σ₁' = σ₃' (1 + sin φ)/(1 − sin φ) + 2 c cos φ/(1 − sin φ) at σ₃' = 40 kPa, φ = 22°, c = 15 kPa.
  const double sine = std::sin(sim::radians(22)), cosine = std::cos(sim::radians(22));
  const double major = 40e3 * (1 + sine) / (1 - sine) + 2 * 15e3 * cosine / (1 - sine);
  const LimitSurface limit(with_cohesion(15e3, 22));
  const double q = major - 40e3;
  CHECK(sim::degrees(limit.mobilised_angle(q, 40e3 + q / 3)) == Approx(22));
  CHECK(sim::degrees(limit.mobilised_angle(-q, 40e3 + 2 * q / 3)) == Approx(22));
  const LimitSurface friction({});
  CHECK(friction.mobilised_angle(120e3, 100e3) == Approx(sim::mobilised_friction_angle(1.2)));
}

TEST_CASE("LimitSurface: a state is steep if its mobilised angle is above the limit") {
  constexpr double kLimit = assessment_limits::kSteepest;
  const double at_limit = sim::stress_ratio_at_friction_angle(kLimit);
  for (const double cohesion : {0.0, 30e3}) {
    const LimitSurface limit(with_cohesion(cohesion, 35));
    for (const double p : {-20e3, 0.0, 50e3, 100e3})
      for (const double ratio : {-3.0, -1.0, 0.0, 0.3, 1 - 1e-3, 1 - 1e-9, 1.0, 1 + 1e-9, 1.2, 4.0})
        CHECK(limit.is_steep(ratio * at_limit * p, p) ==
              (limit.mobilised_angle(ratio * at_limit * p, p) > kLimit));
  }
  CHECK_FALSE(LimitSurface({}).is_steep(1.95 * kP, kP));  // 47°
  CHECK(LimitSurface({}).is_steep(2.2 * kP, kP));         // 54°
  CHECK_FALSE(LimitSurface({}).is_steep(std::numeric_limits<double>::quiet_NaN(), kP));
}

TEST_CASE("LimitSurface: without cohesion a steep ratio is explained by it") {
  const LimitSurface unknown({});
  CHECK(unknown.needs_cohesion(1.9 * kP, kP).empty());  // 46°
  CHECK_THAT(unknown.needs_cohesion(2.23 * kP, kP), Catch::Contains("q/p' is 2.23") &&
                                                        Catch::Contains("54.4°") &&
                                                        Catch::Contains("specimen.cohesion_kPa"));
  CHECK_FALSE(unknown.needs_cohesion(-1.3 * kP, kP).empty());
  CHECK(LimitSurface(with_cohesion(20e3, 24)).needs_cohesion(2.23 * kP, kP).empty());
  SpecimenInfo clay;
  clay.cohesion_pa = 20e3;
  CHECK(LimitSurface(clay).needs_cohesion(124.8e3, 55.9e3).empty());  // 37° at c' = 20 kPa
}

TEST_CASE("LimitSurface: with cohesion a q below it mobilises no friction") {
  SpecimenInfo clay;
  clay.cohesion_pa = 20e3;
  LimitSurface limit(clay);
  limit.add(1, 5e3, 100e3);
  CHECK(*limit.stress_ratio() == 0);
  limit.add(2, 160e3, 100e3);
  CHECK(*limit.stress_ratio() > 1);
}

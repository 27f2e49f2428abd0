// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/limit_surface.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "sim/mechanics/axisymmetric.hpp"

using namespace triax;
using namespace triax::lab;

TEST_CASE("a given friction angle is the limit, in compression and in extension") {
  SpecimenInfo specimen;
  specimen.limit_friction_angle_rad = sim::radians(32);
  LimitSurface given(specimen);
  given.add(1, 250e3, 100e3);  // what the test mobilised does not matter then
  CHECK(*given.stress_ratio() == Approx(1.2872).epsilon(1e-4));
  CHECK(given.inside(1.20, 5) == true);
  CHECK(given.inside(1.25, 5) == false);
  CHECK(given.inside(-0.85, 5) == true);  // 6 sin φ/(3 + sin φ) = 0.9008
  CHECK(given.inside(-0.88, 5) == false);
}

TEST_CASE("without one the ratio at which a specimen fell excuses nothing") {
  LimitSurface own({});
  CHECK_FALSE(own.stress_ratio());
  CHECK_FALSE(own.inside(0.5, 5));
  for (int i = 0; i < 100; ++i) own.add(i, 1e3 * i, 140e3);  // to η = 0.71, the largest
  CHECK(*own.stress_ratio() == Approx(0.707).margin(1e-3));
  CHECK_FALSE(own.inside(0.70, 98));
  CHECK_FALSE(own.went_beyond(0.70));
}

TEST_CASE("LimitSurface: the largest ratio of a test is no limit to be inside of") {
  LimitSurface own({});
  own.add(10, 70e3, 100e3);
  CHECK_FALSE(own.went_beyond(0.7));
  own.add(200, 13e3, 10e3);
  CHECK(own.went_beyond(0.7));
  CHECK_FALSE(own.inside(0.7, 10));
  CHECK_THAT(own.source(false),
             Catch::Contains("unknown: no friction angle is given, and the 32.3°"));
}

TEST_CASE("LimitSurface: a path along a ratio does not put a lower onset inside") {
  LimitSurface own({});
  for (int i = 0; i <= 100; ++i) own.add(i, 1.35 * 1e3 * (100 + i), 1e3 * (100 + i));
  CHECK(own.went_beyond(0.7));
  CHECK_FALSE(own.inside(0.7, 100));
}

TEST_CASE("a path that had walked along its largest ratio before knew its limit") {
  LimitSurface own({});
  for (int i = 0; i <= 100; ++i) own.add(i, 1.35 * 1e3 * (100 + i), 1e3 * (100 + i));
  CHECK(own.inside(1.34, 100) == false);
  CHECK(own.source(true) == "largest stress ratio of this test, at which the specimen failed");
  CHECK_FALSE(own.inside(1.34, 15));  // not yet: q had grown by less than a fifth
}

TEST_CASE("a ratio that falls at the same p' was a limit; one that is lost with p' was not") {
  LimitSurface clay({}), sand({});
  for (int i = 0; i <= 100; ++i) {
    clay.add(i, 0.9e3 * i, 40e3);
    sand.add(i, 0.9e3 * i, 160e3);
  }
  CHECK_FALSE(clay.inside(2.25, 100));
  clay.add(150, 75e3, 41e3);
  CHECK(clay.inside(2.25, 100) == false);
  sand.add(101, 10e3, 40e3);  // fell within a reading: q and p' are gone
  CHECK_FALSE(sand.inside(0.56, 100));
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
  CHECK(given.below(0.6436) == Approx(0.5).epsilon(1e-3));
  CHECK(given.below(-0.9008) == Approx(0).margin(1e-3));
  LimitSurface own({});
  own.add(1, 100e3, 100e3);
  CHECK(own.below(0.9) == 1);
}

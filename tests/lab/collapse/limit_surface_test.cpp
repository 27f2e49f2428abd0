// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/limit_surface.hpp"

#include <catch2/catch.hpp>

#include "sim/mechanics/axisymmetric.hpp"

using namespace triax;
using namespace triax::lab;

TEST_CASE("a given friction angle rules; without it the test's own largest ratio does") {
  SpecimenInfo specimen;
  PathPoint point;
  point.p_eff = 100e3;
  point.q = 138e3;
  LimitSurface measured(specimen);
  CHECK_FALSE(measured.stress_ratio());
  CHECK_FALSE(measured.inside(0.5));
  measured.add(point);
  CHECK(*measured.stress_ratio() == Approx(1.38));
  point.p_eff = 1e3;  // noise near p' = 0 must not set the limit
  point.q = 2.5e3;
  measured.add(point);
  CHECK(*measured.stress_ratio() == Approx(1.38));
  CHECK(measured.inside(1.30));
  CHECK_FALSE(measured.inside(1.35));

  specimen.limit_friction_angle_rad = sim::radians(32);
  LimitSurface given(specimen);
  given.add(point);
  CHECK(*given.stress_ratio() == Approx(1.2872).epsilon(1e-4));
}

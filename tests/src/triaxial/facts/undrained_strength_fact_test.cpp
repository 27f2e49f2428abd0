// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/undrained_strength_fact.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("undrained_strength_lines: at the peak, at 20 % and 15 %, and of a short test") {
  lab::UndrainedStrength strength{.at = {21, 630.0, 0.105, 176e3, {}, {}},
                                  .at_15_pct = {},
                                  .last_axial_strain = 0.155,
                                  .peaked = true};
  auto lines = src::undrained_strength_lines(strength);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0] == "c_u = 88.0 kPa at 10.5 % axial strain (peak of q / 2)");
  strength.peaked = false;
  lines = src::undrained_strength_lines(strength);
  CHECK(lines[0] ==
        "c_u = 88.0 kPa at 10.5 % axial strain (q / 2; q was still rising when shear ended at 15.5 "
        "%)");
  strength.at.axial_strain = 0.2;
  strength.last_axial_strain = 0.25;
  strength.at_15_pct = lab::Instant{30, 900.0, 0.15, -150e3, {}, {}};
  lines = src::undrained_strength_lines(strength);
  REQUIRE(lines.size() == 2);
  CHECK(
      lines[0] ==
      "c_u = 88.0 kPa at 20.0 % axial strain (q / 2; q had no peak before 20 %, the failure strain "
      "of ISO 17892-8)");
  CHECK(
      lines[1] ==
      "c_u = 75.0 kPa at 15.0 % axial strain (q / 2; q had no peak before 15 %, the failure strain "
      "of ASTM D2850)");
}

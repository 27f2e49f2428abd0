// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/spoken_unit.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("channels are spoken of in the unit of their column, a load cell in newtons") {
  CHECK(spoken_unit(Quantity::axial_force).name == "N");
  CHECK(spoken_unit(Quantity::axial_force).scale == 1);
  CHECK(spoken_unit(Quantity::pore_pressure).name == "kPa");
  CHECK(spoken_unit(Quantity::axial_displacement).name == "mm");
  CHECK(spoken_unit(Quantity::back_volume).name == "mm3");
}

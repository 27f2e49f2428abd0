// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/ramp_target.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

constexpr double kStep_pa = 20;
const EndCondition kAbove400{
    .quantity = EndQuantity::cell_pressure, .above = 400e3, .below = std::nullopt};

}  // namespace

TEST_CASE("RampTarget: a set point that comes as predicted reaches its target at once") {
  RampTarget target;
  target.look(399e3, 399e3);
  CHECK_FALSE(target.met(kAbove400, kStep_pa));
  target.look(400e3 - 10, 400e3);
  CHECK(target.met(kAbove400, kStep_pa));
}

TEST_CASE("RampTarget: one look far from the ramp reaches nothing, two do") {
  RampTarget target;
  target.look(342.7e3, 342.7e3);
  target.look(342.7e3, 3342.7e3);
  CHECK_FALSE(target.met(kAbove400, kStep_pa));
  SECTION("the next look is right") {
    target.look(3342.7e3, 342.7e3);
    CHECK_FALSE(target.met(kAbove400, kStep_pa));
  }
  SECTION("the controller was faster than predicted") {
    target.look(342.7e3, 400e3);
    CHECK(target.met(kAbove400, kStep_pa));
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/axis_drive.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;

TEST_CASE("Grains: drives are made by what they hold") {
  CHECK(AxisDrive{} == strain_rate_drive(0));
  CHECK(strain_rate_drive(0.1).strain_rate_per_s == 0.1);
  const AxisDrive stress = stress_drive(1e5, 0.05);
  CHECK(stress.kind == AxisDrive::Kind::stress);
  CHECK(stress.stress_goal_pa == 1e5);
  CHECK(stress.speed_limit_m_per_s == 0.05);
  const AxisDrive follower = following_drive(1, -0.5);
  CHECK(follower.kind == AxisDrive::Kind::follows);
  CHECK(follower.leader == 1);
  CHECK(follower.ratio == -0.5);
}

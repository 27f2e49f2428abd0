// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/specimen_state.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;

TEST_CASE("the balance of work has what comes in on one side") {
  StepWork work;
  work.axial = 7;
  work.cell = 2;
  work.drainage = -1;
  work.impulse = 0.5;
  work.skeleton = 3;
  work.membrane = 1;
  work.water = -1;
  work.damping = 2;
  work.stop = 1.5;
  work.kinetic = 2;
  CHECK(work.balance() == 0);
}

TEST_CASE("a state is a plain value") {
  SpecimenState one;
  one.run_away.under_way = true;
  one.material.memory = Memory::Constant(3, 1.5);
  const SpecimenState two = one;
  one.material.memory(0) = 0;
  one.run_away.under_way = false;
  CHECK(two.run_away.under_way);
  CHECK(two.material.memory(0) == 1.5);
}

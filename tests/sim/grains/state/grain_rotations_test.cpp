// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_rotations.hpp"

#include <catch2/catch.hpp>

#include "sim/grains/engine/grains.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

TEST_CASE("Grain rotations: a spinning sphere turns by spin times time, under its own number") {
  GrainState state = make_grain_state({{{0.1, 0, 0}, 1e-3}, {{-0.1, 0, 0}, 2e-3}},
                                      test::far_walls(), test::undamped(), 1e-6);
  test::grain(state, 1).spin[2] = 5;
  test::grain(state, 0).spin[0] = -2;
  Grains grains(state);
  GrainRotations rotations(2);
  for (int s = 0; s < 300; ++s) {
    grains.step(1);
    rotations.add(grains.state());
  }
  CHECK(rotations.turned()[1].z() == Approx(5 * 3e-4));
  CHECK(rotations.turned()[0].x() == Approx(-2 * 3e-4));
  CHECK(rotations.turned()[1].x() == 0);
}

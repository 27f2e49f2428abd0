// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/guarded_steps.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

TEST_CASE("Guarded steps: a grain beyond a wall is found") {
  GrainState state = test::lattice(2);
  CHECK(grains_outside(state) == 0);
  CHECK_NOTHROW(require_inside(state));
  state.grains[3].position[1] = state.box.high_m[1] + 1e-9;
  CHECK(grains_outside(state) == 1);
  CHECK_THROWS_AS(require_inside(state), GrainsFailed);
}

TEST_CASE("Guarded steps: a run that flies apart is no success") {
  Grains grains(test::pair_of(1e-3, 1e-3, 1e-4, test::undamped(), 1e-6));
  CHECK_NOTHROW(advance(grains, 10));
  CHECK(grains.state().steps == 10);
  grains.set_time_step(1);
  CHECK_THROWS_AS(advance(grains, 100), GrainsFailed);
}

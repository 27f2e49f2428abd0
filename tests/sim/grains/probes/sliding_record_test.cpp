// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/sliding_record.hpp"

#include <catch2/catch.hpp>

#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

TEST_CASE("Sliding record: a contact counts once, and stays counted") {
  GrainState state = test::pair_of(1e-3, 1e-3, 1e-5, test::undamped(), 1e-7);
  SlidingRecord record(state);
  Grains grains(state);
  grains.step(1);
  record.add(grains.state());
  CHECK(record.count() == 0);
  test::grain(state, 1).velocity[1] = 100;
  grains.restore(state);
  grains.step(4);
  REQUIRE(measure(grains.state()).sliding_contacts == 1);
  record.add(grains.state());
  record.add(grains.state());
  CHECK(record.count() == 1);
}

TEST_CASE(
    "Sliding record: a contact that rests at its limit does not slide until its load changes") {
  GrainState state = test::pair_of(1e-3, 1e-3, 1e-5, test::undamped(), 1e-7);
  test::grain(state, 1).velocity[1] = 100;
  Grains grains(state);
  grains.step(4);
  grains.stop_motion();
  grains.step(1);  // forces of the stopped grains
  REQUIRE(measure(grains.state()).sliding_contacts == 1);
  SlidingRecord record(grains.state());
  record.add(grains.state());
  CHECK(record.count() == 0);
  GrainState moved = grains.state();
  test::grain(moved, 1).velocity[0] = -1;  // closer: more normal force
  test::grain(moved, 1).velocity[1] = 100;
  grains.restore(moved);
  grains.step(3);
  REQUIRE(measure(grains.state()).sliding_contacts == 1);
  record.add(grains.state());
  CHECK(record.count() == 1);
}

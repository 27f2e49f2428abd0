#include "sim/grains/sliding_record.hpp"

#include <catch2/catch.hpp>

#include "sim/grains/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

TEST_CASE("Sliding record: a contact counts once, and stays counted") {
  GrainState state = test::pair_of(1e-3, 1e-3, 1e-5, test::undamped(), 1e-7);
  SlidingRecord record;
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

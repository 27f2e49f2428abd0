// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/cells.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

TEST_CASE("Grains: sorting moves each grain, with its id, to the place it says") {
  GrainState s = test::lattice(6);
  std::reverse(s.grains.begin(), s.grains.end());
  std::reverse(s.ids.begin(), s.ids.end());
  const GrainState before = s;
  const auto place = CellGrid(s).sort(s);
  REQUIRE(place.size() == s.grains.size());
  for (std::size_t i = 0; i < place.size(); ++i) {
    CHECK(s.grains[place[i]] == before.grains[i]);
    CHECK(s.ids[place[i]] == before.ids[i]);
  }
  CHECK_FALSE(s.ids == before.ids);
}

TEST_CASE("Grains: sorting what is sorted changes nothing") {
  GrainState s = test::lattice(5);
  const GrainState before = s;
  CellGrid(s).sort(s);
  CHECK(s.ids == before.ids);
}

TEST_CASE("Grains: grains beyond a wall belong to the outermost cell") {
  GrainState s = test::lattice(4);
  s.grains[5].position[0] = -1;
  s.grains[6].position[2] = 9;
  const auto place = CellGrid(s).sort(s);
  CHECK(*std::max_element(place.begin(), place.end()) == 63);
  CHECK(*std::min_element(place.begin(), place.end()) == 0);
}

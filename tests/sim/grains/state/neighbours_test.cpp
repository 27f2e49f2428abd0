// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/neighbours.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

namespace {

using Pair = std::pair<int, int>;

/// Tangential force of each pair of described grains, as the lower number feels it.
std::map<Pair, std::array<double, 3>> forces_of(const GrainState& s) {
  std::map<Pair, std::array<double, 3>> forces;
  const NearPairs& near = s.neighbours.near;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const int a = s.ids[near.i[k]], b = s.ids[near.j[k]];
    std::array<double, 3> t{};
    for (int x = 0; x < 3; ++x) t[x] = (a < b ? 1 : -1) * near.tangential_n[x][k];
    if (t[0] != 0 || t[1] != 0 || t[2] != 0) forces[{std::min(a, b), std::max(a, b)}] = t;
  }
  return forces;
}

double gap(const Grain& a, const Grain& b) {
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1],
                    a.position[2] - b.position[2]) -
         a.radius - b.radius;
}

}  // namespace

TEST_CASE("Grains: sorting finds every pair within the margin, in order") {
  GrainState s = test::lattice(7);
  s.margin = {3e-4, 5e-5};
  sort_grains(s);
  std::set<Pair> expected, near_expected;
  for (std::size_t i = 0; i < s.grains.size(); ++i)
    for (std::size_t j = i + 1; j < s.grains.size(); ++j) {
      if (gap(s.grains[i], s.grains[j]) < s.margin.listed_m) expected.insert({i, j});
      if (gap(s.grains[i], s.grains[j]) < s.margin.near_m) near_expected.insert({i, j});
    }
  std::vector<Pair> listed, near;
  for (std::size_t k = 0; k < s.neighbours.listed_i.size(); ++k)
    listed.emplace_back(s.neighbours.listed_i[k], s.neighbours.listed_j[k]);
  for (std::size_t k = 0; k < s.neighbours.near.size(); ++k)
    near.emplace_back(s.neighbours.near.i[k], s.neighbours.near.j[k]);
  CHECK(std::is_sorted(listed.begin(), listed.end()));
  CHECK(std::vector<Pair>(expected.begin(), expected.end()) == listed);
  CHECK(std::vector<Pair>(near_expected.begin(), near_expected.end()) == near);
  CHECK(listed.size() > near.size());
}

TEST_CASE("Grains: tangential forces survive sorting and renewing") {
  GrainState state = test::lattice(6);
  test::shake(state, 0.3);
  Grains grains(state);
  grains.step(60);
  GrainState s = grains.state();
  const auto before = forces_of(s);
  REQUIRE(before.size() > 100);
  s.margin.listed_m *= 1.5;
  sort_grains(s);
  CHECK(forces_of(s) == before);
  renew_neighbours(s);
  CHECK(forces_of(s) == before);
  for (Grain& g : s.grains)  // mirrored: the order of the cells is reversed
    for (int a = 0; a < 3; ++a) g.position[a] = s.box.low_m[a] + s.box.high_m[a] - g.position[a];
  sort_grains(s);
  CHECK(forces_of(s) == before);
}

TEST_CASE("Grains: no contact is ever missed while grains fly about") {
  GrainState state = test::lattice(6, {}, 2.6e-3);
  test::shake(state, 2);
  Grains grains(state);
  int contacts = 0;
  for (int s = 0; s < 300; ++s) {
    grains.step(3);
    const GrainState& now = grains.state();
    std::set<Pair> near;
    for (std::size_t k = 0; k < now.neighbours.near.size(); ++k)
      near.insert({now.neighbours.near.i[k], now.neighbours.near.j[k]});
    for (int i = 0; i < 216; ++i)
      for (int j = i + 1; j < 216; ++j)
        if (gap(now.grains[i], now.grains[j]) < 0) {
          ++contacts;
          if (!near.count({i, j})) FAIL("contact not listed");
        }
  }
  CHECK(contacts > 1000);
  CHECK(grains.state().sorts > 3);
}

TEST_CASE("Grains: margins follow the smallest radius") {
  const NeighbourMargin m = neighbour_margin(2e-3);
  CHECK(m.listed_m == Approx(2 * neighbour_margin(1e-3).listed_m));
  CHECK(m.near_m < m.listed_m);
}

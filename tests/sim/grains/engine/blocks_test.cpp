// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/blocks.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

TEST_CASE("Grains: blocks together move grains as one block would, to round-off") {
  GrainState s = test::lattice(9);
  test::shake(s, 0.1);
  GrainState whole = s;
  Blocks blocks(s);
  REQUIRE(blocks.count() == 2);
  const Kernels kernels = triax::sim::kernels(InstructionSet::portable);
  for (int b = 0; b < 2; ++b) blocks.load(s, kernels, b);
  for (int b = 0; b < 2; ++b) blocks.move(s, kernels, b);
  WallState walls = s.walls;
  blocks.sum_walls(walls);

  NearPairs& near = whole.neighbours.near;
  AlignedVector<GrainLoad> loads(whole.grains.size());
  PairRange r{whole.grains.data(),
              loads.data(),
              0,
              0,
              static_cast<std::int64_t>(near.size()),
              near.i.data(),
              near.j.data(),
              near.tangential_n[0].data(),
              near.tangential_n[1].data(),
              near.tangential_n[2].data(),
              near.stiffness_n_per_m.data(),
              near.reach_m.data(),
              near.half_difference_m.data(),
              friction_coefficient(whole.law),
              whole.law.tangential_ratio * whole.time_step_s,
              0.5 * whole.time_step_s};
  portable_pairs(r);
  double low_wall = 0;
  for (std::size_t i = 0; i < whole.grains.size(); ++i)
    for (int w = 0; w < 6; ++w) {
      const Grain& g = whole.grains[i];
      const double x = g.position[w / 2];
      const double overlap =
          g.radius - (w % 2 == 0 ? x - whole.box.low_m[w / 2] : whole.box.high_m[w / 2] - x);
      if (overlap <= 0) continue;
      const double push = wall_stiffness(whole.law, g.radius) * overlap;
      loads[i].force[w / 2] += w % 2 == 0 ? push : -push;
      if (w == 0) low_wall += push;
    }
  const FastestTwo f = portable_motion({whole.grains.data(), loads.data(),
                                        static_cast<std::int64_t>(whole.grains.size()),
                                        whole.time_step_s, whole.law.damping});
  REQUIRE(low_wall > 1);
  CHECK(walls.force_n[0] == Approx(low_wall).epsilon(1e-12));
  CHECK(blocks.fastest().first == Approx(f.first).epsilon(1e-12));
  CHECK(blocks.fastest().second == Approx(f.second).epsilon(1e-12));
  double largest = 0;
  for (std::size_t i = 0; i < whole.grains.size(); ++i)
    for (int a = 0; a < 3; ++a)
      largest = std::max(largest, std::abs(whole.grains[i].velocity[a] - s.grains[i].velocity[a]));
  CHECK(largest < 1e-12);
}

TEST_CASE("Grains: the number of blocks is a function of the number of grains alone") {
  CHECK(Blocks(test::lattice(3)).count() == 1);
  CHECK(Blocks(test::lattice(9)).count() == 2);
  CHECK(Blocks(test::lattice(17)).count() == 4);
}

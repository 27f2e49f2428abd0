// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_state.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "sim/grains/state/critical_time_step.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

TEST_CASE("Grains: spheres come back in the order of their description") {
  std::vector<Sphere> spheres;
  for (int i = 0; i < 50; ++i)
    spheres.push_back({{0.4 - 0.016 * i, 0.3 - 0.01 * i, 0.01 * (i % 7)}, 1e-3 + 1e-6 * i});
  const GrainState state = make_grain_state(spheres, test::far_walls(), ContactLaw{});
  const auto back = spheres_of(state);
  REQUIRE(back.size() == spheres.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    CHECK(back[i].centre_m == spheres[i].centre_m);
    CHECK(back[i].radius_m == spheres[i].radius_m);
  }
  CHECK(state.ids != std::vector<std::int32_t>{});
  CHECK(state.ids[0] != 0);
}

TEST_CASE("Grains: a copy is equal until something changes") {
  const GrainState state = test::lattice(3);
  GrainState copy = state;
  CHECK(copy == state);
  copy.neighbours.near.tangential_n[1].at(0) = 1e-9;
  CHECK_FALSE(copy == state);
}

TEST_CASE("Grains: the time step is given or follows from the critical one") {
  const GrainState state = test::lattice(3);
  CHECK(state.time_step_s == 1e-6);
  const GrainState chosen = make_grain_state(spheres_of(state), state.box, state.law);
  CHECK(chosen.time_step_s == Approx(0.6 * critical_time_step(chosen)));
}

TEST_CASE("Grains: descriptions that make no specimen are refused") {
  const GrainBox box = test::far_walls();
  const auto refused = [](const std::vector<Sphere>& spheres, const GrainBox& b) {
    CHECK_THROWS_AS(make_grain_state(spheres, b, ContactLaw{}), std::invalid_argument);
  };
  refused({}, box);
  refused({{{0, 0, 0}, 0}}, box);
  refused({{{0, 0.6, 0}, 1e-3}}, box);
  GrainBox flat = box;
  flat.high_m[2] = flat.low_m[2];
  refused({{{0, 0, -0.5}, 1e-3}}, flat);
  refused({{{0, 0, 0}, 1e-3}, {{0, 0, 0}, 2e-3}}, box);
}

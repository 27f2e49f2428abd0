// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/critical_time_step.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

namespace {

/// One sphere between two walls; its amplitude after many steps of `factor` times the exact limit
/// 2/ω over that at the start.
double swing(double factor) {
  const double r = 1e-3;
  GrainBox box = test::far_walls();
  box.low_m[0] = -r + 1e-4;
  box.high_m[0] = r - 1e-4;
  GrainState state = make_grain_state({{{0, 0, 0}, r}}, box, test::undamped());
  const double rate = std::sqrt(2 * wall_stiffness(state.law, r) / test::mass(state.grains[0]));
  CHECK(critical_time_step(state) < 2 / rate);
  state.time_step_s = factor * 2 / rate;
  state.grains[0].position[0] = 1e-9;
  Grains grains(state);
  double largest = 0;
  for (int s = 0; s < 100; ++s) {
    grains.step(1);
    largest = std::max(largest, std::abs(grains.state().grains[0].position[0]));
  }
  return largest / 1e-9;
}

/// Kinetic energy of a compressed packing without friction's limit and damping after a run at
/// `factor` times the critical step, over that given to it.
double growth(double factor) {
  Grains grains(test::lattice(5));
  grains.drive({stress_drive(3e5), stress_drive(3e5), stress_drive(3e5)});
  grains.step(30000);
  grains.stop_motion();
  GrainState state = grains.state();
  state.law = test::undamped(1.5);
  state.walls.drive = {};
  test::shake(state, 1e-4);
  state.time_step_s = factor * critical_time_step(state);
  const double given = kinetic_energy(state);
  grains.restore(state);
  grains.step(2000);
  return kinetic_energy(grains.state()) / given;
}

}  // namespace

TEST_CASE("Grains: the critical step is below that of a pair and scales with the square root") {
  const GrainState pair = test::pair_of(1e-3, 1e-3, 1e-6, ContactLaw{});
  const double exact =
      2 / std::sqrt(2 * normal_stiffness(pair.law, 1e-3, 1e-3) / test::mass(pair.grains[0]));
  CHECK(critical_time_step(pair) < exact);
  CHECK(critical_time_step(pair) > 0.4 * exact);
  ContactLaw stiff;
  stiff.stiffness_over_diameter_pa *= 4;
  const GrainState stiffer = test::pair_of(1e-3, 1e-3, 1e-6, stiff);
  CHECK(critical_time_step(stiffer) == Approx(0.5 * critical_time_step(pair)));
}

TEST_CASE("Grains: more contacts mean a shorter critical step") {
  const double loose = critical_time_step(test::lattice(5, {}, 2.6e-3)),
               dense = critical_time_step(test::lattice(5, {}, 2.0e-3));
  CHECK(dense < 0.8 * loose);
}

TEST_CASE("Grains: the limit of stability of one sphere is the closed form") {
  CHECK(swing(0.99) < 20);
  CHECK(swing(1.01) > 1e3);
}

TEST_CASE("Grains: a packing is stable at the critical step and not far above it") {
  CHECK(growth(1) < 3);
  CHECK(growth(3) > 1e3);
}

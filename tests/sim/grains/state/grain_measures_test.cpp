// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_measures.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

TEST_CASE("Grains: counts of a chain of three between two walls, and one that floats") {
  const double r = 1e-3, held = 1e-6;
  GrainBox box = test::far_walls();
  box.low_m[0] = -3 * r + held;
  box.high_m[0] = 3 * r - held;
  const double apart = 2 * r - held / 2;
  Grains grains(
      make_grain_state({{{-apart, 0, 0}, r}, {{0, 0, 0}, r}, {{apart, 0, 0}, r}, {{0, 0.1, 0}, r}},
                       box, test::undamped(), 1e-9));
  grains.step(1);
  const GrainMeasures m = measure(grains.state());
  CHECK(m.grain_contacts == 2);
  CHECK(m.wall_contacts == 2);
  CHECK(m.coordination == Approx(6.0 / 4));
  CHECK(m.floating_grains == 1);
  CHECK(m.grains_outside == 0);
  const double solid = 4 * 4 * std::numbers::pi / 3 * r * r * r;
  CHECK(m.porosity == Approx(1 - solid / grains.state().box.volume_m3()));
  CHECK(m.void_ratio == Approx(grains.state().box.volume_m3() / solid - 1));
  const double force = 356e6 * r * held / 2;
  CHECK(m.wall_stress_pa[0] == Approx(force / box.area_m2(0)).epsilon(1e-6));
  CHECK(m.wall_stress_pa[1] == 0);
  CHECK(m.stress_pa(0, 0) == Approx(force / box.area_m2(0)).epsilon(1e-6));
  CHECK(std::abs(m.stress_pa(1, 1)) + std::abs(m.stress_pa(0, 1)) == 0);
  CHECK(m.unbalanced < 1e-6);
}

TEST_CASE("Grains: at rest the contacts carry what the walls measure") {
  Grains grains(test::lattice(6));
  grains.drive({stress_drive(3e5), stress_drive(4e5), stress_drive(3.5e5)});
  grains.step(60000);
  const GrainMeasures m = measure(grains.state());
  for (int a = 0; a < 3; ++a) CHECK(m.stress_pa(a, a) == Approx(m.wall_stress_pa[a]).epsilon(2e-3));
  CHECK(m.grain_contacts > 400);
}

TEST_CASE("Grains: one grain between no contacts is out of balance by nothing") {
  GrainState state = make_grain_state({{{0, 0, 0}, 1e-3}}, test::far_walls(), ContactLaw{});
  const GrainMeasures m = measure(state);
  CHECK(m.unbalanced == 0);
  CHECK(m.floating_grains == 1);
  CHECK(m.kinetic_energy_j == 0);
}

TEST_CASE("Grains: kinetic energy counts spin") {
  GrainState state = make_grain_state({{{0, 0, 0}, 1e-3}}, test::far_walls(), ContactLaw{});
  state.grains[0].spin[1] = 100;
  const double mass = test::mass(state.grains[0]);
  CHECK(kinetic_energy(state) == Approx(0.5 * 0.4 * mass * 1e-6 * 1e4));
}

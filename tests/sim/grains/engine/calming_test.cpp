// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/calming.hpp"

#include <catch2/catch.hpp>

#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"
#include "tests/sim/grains/specimens.hpp"

using namespace triax::sim;

TEST_CASE("Calming: takes out the energy of floating grains that damping leaves") {
  GrainState state = test::calm_state();
  test::shake(state, 1e-3);
  Grains left(state), calmed(state);
  left.step(2000);
  calm(calmed);
  CHECK(calmed.state().steps == state.steps + 2000);
  CHECK(kinetic_energy(calmed.state()) < 1e-2 * kinetic_energy(left.state()));
}

TEST_CASE("Settling: ends when at rest at the goals, or at the bound of steps") {
  Grains grains(test::calm_state());
  grains.drive(triaxial_drives(stress_drive(2.02e5), stress_drive(1e5)));
  CHECK(stress_error(grains.state()) == Approx(2000).margin(20));
  Settling how;
  how.unbalanced = 1e-4;
  how.stress_error_pa = 10;
  how.most_steps = 700;
  const Settled few = settle(grains, how);
  CHECK_FALSE(few.at_rest);
  CHECK(few.steps == 700);
  how.most_steps = 200000;
  const Settled enough = settle(grains, how);
  CHECK(enough.at_rest);
  CHECK(enough.unbalanced < 1e-4);
  CHECK(stress_error(grains.state()) < 10);
  how.unbalanced = 1e-30;
  CHECK(settle(grains, how, [](double, const std::string&) { return false; }).stopped);
}

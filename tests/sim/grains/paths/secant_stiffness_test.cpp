// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/secant_stiffness.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;

namespace {

using Pair = Vector<Axisymmetric>;

SecantStiffness known() {
  SecantStiffness k;
  k.elastic << 100, 30, 30, 120;
  k.going_on = k.elastic;
  return k;
}

}  // namespace

TEST_CASE("An increment is taken over, and nothing else is changed") {
  const Pair strain{2, 1}, stress{50, 60}, across{-1, 2};
  const SecantStiffness after = known().with(strain, stress);
  CHECK((after.going_on * strain - stress).norm() < 1e-12);
  CHECK((after.going_on * across - known().elastic * across).norm() < 1e-12);
  CHECK(after.elastic == known().elastic);
  CHECK((after.direction - strain.normalized()).norm() < 1e-15);
}

TEST_CASE("Against the last increment the stiffness is elastic, and starts anew from there") {
  const Pair strain{2, 1}, stress{50, 60};
  const SecantStiffness loaded = known().with(strain, stress);
  CHECK(loaded.towards(strain) == loaded.going_on);
  CHECK(loaded.towards(-strain) == loaded.elastic);
  const Pair back = -strain, back_stress = known().elastic * back;
  const SecantStiffness unloaded = loaded.with(back, back_stress);
  CHECK((unloaded.going_on - known().elastic).norm() < 1e-12);
  CHECK(unloaded.towards(back) == unloaded.going_on);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/water.hpp"

#include <catch2/catch.hpp>

#include "sim/specimen/pore_air.hpp"
#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEST_CASE("the water's content has the compliance of its parts") {
  const double space = 2.8e-4, air = amount_of_air(space, 0.98, 300e3);
  const PoreWater water(1 / 2e9, 5e-13, 300e3);
  const auto now = water.content(space, 340e3, air);
  const double up = water.content(space, 340.01e3, air).amount_m3;
  const double down = water.content(space, 339.99e3, air).amount_m3;
  CHECK((up - down) / 20 == Approx(now.compliance).epsilon(1e-6));
  CHECK((water.content(space * 1.001, 340e3, air).amount_m3 - now.amount_m3) / (1e-3 * space) ==
        Approx(now.per_space).epsilon(1e-9));
  CHECK((water.content(space, 340e3, air * 1.001).amount_m3 - now.amount_m3) / (1e-3 * air) ==
        Approx(now.per_air).epsilon(1e-6));

  const auto full = water.content(space, 300e3, 0);
  CHECK(full.amount_m3 == space);
  CHECK(full.compliance == Approx(space / 2e9 + 5e-13).epsilon(1e-12));
  CHECK(PoreWater(0, 0, 300e3).rigid());
  CHECK_FALSE(water.rigid());
}

TEST_CASE("the water's balance closes at every step and does not drift") {
  SpecimenProperties p = real();
  p.saturation = GENERATE(1.0, 0.97);
  p.drainage_resistance = GENERATE(0.0, 1e10);
  const Specimen specimen = loose(sanisand_of_s28(), p);
  const double allowed = 1e-12 * specimen.volume_m3(specimen.start());
  SpecimenState state = specimen.start();
  double worst = 0;
  const auto go = [&](const SpecimenBoundary& b, int count) {
    for (int i = 0; i < count; ++i) {
      const auto step = specimen.advance(state, b, 0.5);
      REQUIRE(accepted(step));
      state = step.state;
      worst = std::max(worst, std::abs(specimen.water_imbalance_m3(state)));
    }
  };
  go(moved(2e-6, Water::drained), 200);
  go(moved(1e-5), 100);
  SpecimenBoundary flow = moved(1e-5, Water::flow);
  flow.water.flow_m3_per_s = 1e-9;
  go(flow, 100);
  flow.water.flow_m3_per_s = -1e-9;
  go(flow, 100);
  go(constant_q(state.material.q(), -20, Water::closed), 50);
  CHECK(worst < allowed);
  CHECK(worst > 0);
}

TEST_CASE("rigid water that is pushed out takes its volume, over any number of steps") {
  const Specimen specimen = loose(inl2_law_of_s28(), bare());
  SpecimenBoundary b = moved(1e-5, Water::flow);
  b.water.flow_m3_per_s = 2e-9;
  const SpecimenState state = run(specimen, specimen.start(), b, 0.25, 400);
  const double volume = specimen.volume_m3(specimen.start());
  CHECK(specimen.volume_m3(state) == Approx(volume - 2e-9 * 100).epsilon(1e-14));
  CHECK(state.drained_volume_m3 == Approx(2e-7).epsilon(1e-12));
}

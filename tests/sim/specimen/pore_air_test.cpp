// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/pore_air.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEST_CASE("air follows Boyle and Henry") {
  const double space = 2e-4, u = 20e3, p = u + kAtmosphere_pa;
  const double air = amount_of_air(space, 0.95, u);
  const AirySpace there = airy_space(space, u, air);
  CHECK(there.water_m3 == Approx(0.95 * space).epsilon(1e-12));
  const double free = space - there.water_m3;
  CHECK(p * (free + kAirSolubility * there.water_m3) == Approx(air).epsilon(1e-12));
  CHECK(there.dissolved_pa == Approx(kAirSolubility * p));

  const double d = 1e-4;
  CHECK((airy_space(space, u + d, air).water_m3 - airy_space(space, u - d, air).water_m3) /
            (2 * d) ==
        Approx(there.compliance).epsilon(1e-5));
  CHECK((airy_space(space * 1.0001, u, air).water_m3 - there.water_m3) / (1e-4 * space) ==
        Approx(there.water_slope).epsilon(1e-6));
  CHECK((airy_space(space, u, air * 1.0001).water_m3 - there.water_m3) / (1e-4 * air) ==
        Approx(-there.air_displaces).epsilon(1e-6));
}

TEST_CASE("at the pressure of the closed form the last bubble dissolves at constant water") {
  const double space = 2e-4, u = 20e3, saturation = 0.95;
  const double air = amount_of_air(space, saturation, u), water = saturation * space;
  const double gone = dissolving_pressure_pa(saturation, u);
  CHECK(gone == Approx((u + kAtmosphere_pa) * (1 - 0.95 * 0.98) / (0.95 * 0.02) - kAtmosphere_pa));
  CHECK(airy_space(water, gone, air).water_m3 == Approx(water).epsilon(1e-12));
  CHECK(airy_space(water, gone + 1, air).compliance == 0);
  CHECK(airy_space(water * 1.001, gone - 1e3, air).compliance > 0);
}

TEST_CASE("without air there is none at any pressure") {
  CHECK(amount_of_air(1e-4, 1, 0) == 0);
  CHECK(dissolving_pressure_pa(1, 5e3) == 5e3);
  const AirySpace full = airy_space(1e-4, -50e3, 0);
  CHECK(full.water_m3 == 1e-4);
  CHECK(full.compliance == 0);
}

TEST_CASE("back-pressure saturation raises B") {
  SpecimenProperties p = bare();
  p.saturation = 0.96;
  p.water_compressibility = 1 / 2.2e9;
  const Specimen specimen(sanisand_of_s28(), p, 1.0, 20e3, 10e3);
  const auto b_value = [&](const SpecimenState& state) {
    SpecimenBoundary b;
    b.cell_pressure_rate_pa_per_s = 100;
    return (specimen.advance(state, b, 1).state.pore_pressure - state.pore_pressure) / 100;
  };
  SpecimenState state = specimen.start();
  CHECK(specimen.saturation(state) == Approx(0.96).epsilon(1e-12));
  double before = b_value(state);
  CHECK(before < 0.6);
  SpecimenBoundary ramp = moved(0, Water::drained);
  ramp.axis.kind = Axis::free;
  ramp.water.back_pressure_pa = 10e3;
  ramp.cell_pressure_rate_pa_per_s = ramp.water.back_pressure_rate_pa_per_s = 500;
  const double air = state.air_pa_m3;
  for (int stage = 0; stage < 3; ++stage) {
    for (int i = 0; i < 200; ++i) {
      const auto step = specimen.advance(state, ramp, 1);
      REQUIRE(accepted(step));
      state = step.state;
      ramp.water.back_pressure_pa += 500;
    }
    const double now = b_value(state);
    CHECK(now > before);
    before = now;
  }
  CHECK(specimen.saturation(state) == Approx(1).epsilon(1e-12));
  CHECK(before > 0.99);
  // Water that flows in brings no air.
  CHECK(state.drained_volume_m3 < 0);
  CHECK(state.air_pa_m3 == Approx(air).epsilon(1e-9));
  CHECK(std::abs(specimen.water_imbalance_m3(state)) < 1e-12 * specimen.volume_m3(state));
}

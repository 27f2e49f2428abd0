// SPDX-License-Identifier: GPL-3.0-or-later
// A specimen made of grains: what holds for every law has to hold for them, within their tolerance.
#include <catch2/catch.hpp>

#include "tests/sim/grains/law_of_grains.hpp"
#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

Specimen of_grains(const LawOfGrains& law, const SpecimenProperties& properties) {
  return {law, properties, law->void_ratio(), law->pressure_pa(), 300e3};
}

struct Balances {
  double work = 0, energy = 0, water = 0;  ///< largest; energy of all steps, J
};

/// Compressed at a velocity for `steps` ticks; every step has to go on.
SpecimenState compressed(const Specimen& specimen, Water water, int steps, Balances& found) {
  SpecimenState state = specimen.start();
  for (int i = 0; i < steps; ++i) {
    const auto step = specimen.advance(state, moved(2e-5, water), 0.25);
    REQUIRE(accepted(step));
    state = step.state;
    found.work = std::max(found.work, std::abs(step.work.balance()));
    found.energy += step.work.axial;
    found.water = std::max(found.water, std::abs(specimen.water_imbalance_m3(state)));
  }
  return state;
}

}  // namespace

TEST_CASE("undrained grains with stiff water keep their volume, and their balances close") {
  const auto law = dense_grains();
  SpecimenProperties stiff = bare();
  stiff.water_compressibility = 1 / 2.2e9;
  const Specimen specimen = of_grains(law, stiff);
  Balances found;
  const SpecimenState state = compressed(specimen, Water::closed, 30, found);
  const double volume = specimen.volume_m3(specimen.start());
  CHECK(specimen.displacement_m(state) == Approx(30 * 0.25 * 2e-5).epsilon(1e-9));
  // n/K_w = 2e-10 per Pa of pore pressure
  CHECK(std::abs(specimen.volume_m3(state) / volume - 1) < 5e-5);
  CHECK(state.pore_pressure != Approx(300e3).margin(1e3));
  CHECK(state.material.q() > 20e3);
  CHECK(found.water < 1e-8 * volume);
  CHECK(found.work < 1e-3 * found.energy);
  CHECK(state.material.stress(1) / std::sqrt(2) + state.pore_pressure ==
        Approx(state.cell_pressure).epsilon(1e-12));
}

TEST_CASE("drained grains hold the effective cell pressure and give their water") {
  const auto law = loose_grains();
  const Specimen specimen = of_grains(law, bare());
  Balances found;
  const SpecimenState state = compressed(specimen, Water::drained, 30, found);
  CHECK(radial_effective(state) == Approx(law->pressure_pa()).epsilon(2e-3));
  CHECK(state.drained_volume_m3 ==
        Approx(specimen.volume_m3(specimen.start()) - specimen.volume_m3(state)).epsilon(1e-6));
  CHECK(found.work < 1e-3 * found.energy);
}

TEST_CASE("drainage through a resistance lags behind and follows") {
  const auto law = loose_grains();
  SpecimenProperties slow = bare();
  slow.drainage_resistance = 5e11;  // about 5 s for these grains
  const Specimen specimen = of_grains(law, slow);
  SpecimenBoundary b = constant_q(0, 2000, Water::drained);
  const SpecimenState loaded = run(specimen, specimen.start(), b, 0.25, 20);
  CHECK(loaded.pore_pressure > 303e3);
  CHECK(loaded.pore_pressure < 310e3);
  b.cell_pressure_rate_pa_per_s = 0;
  const SpecimenState rested = run(specimen, loaded, b, 0.25, 160);
  CHECK(rested.pore_pressure == Approx(300e3).margin(300));
  CHECK(radial_effective(rested) == Approx(law->pressure_pa() + 10e3).margin(400));
  CHECK(rested.drained_volume_m3 > loaded.drained_volume_m3);
}

TEST_CASE("a specimen of grains that rests is left alone") {
  const auto law = dense_grains();
  const Specimen specimen = of_grains(law, real());
  SpecimenBoundary b = constant_q(0, 0, Water::closed);
  const SpecimenState first = run(specimen, specimen.start(), b, 0.25, 5);
  const SpecimenState later = run(specimen, first, b, 0.25, 50);
  CHECK(later.material.interior == first.material.interior);
  CHECK(later.pore_pressure == Approx(300e3).margin(5));
}

TEST_CASE("a load that loose grains do not carry runs away, with energy from the grains",
          "[slow]") {
  const auto law = very_loose_grains();
  SpecimenProperties stiff = bare();
  stiff.water_compressibility = 1 / 2.2e9;
  const Specimen specimen = of_grains(law, stiff);
  SpecimenBoundary b = dead_load(0, 200);
  b.axis.force_rate_n_per_s = 20;
  b.axis.travel_m = 2e-3;
  SpecimenState state = specimen.start();
  SpecimenStep step;
  for (int i = 0; i < 100 && !step.at_stop; ++i) {
    step = specimen.advance(state, b, 0.25);
    REQUIRE(accepted(step));
    state = step.state;
    b.axis.force_n += 0.25 * b.axis.force_rate_n_per_s;
  }
  REQUIRE(step.at_stop);
  CHECK(state.run_away.count >= 1);
  CHECK(state.run_away.end == RunAway::End::end_of_travel);
  CHECK(state.run_away.largest_kinetic_energy_j > 0.01);
  CHECK(state.material.p() < 0.7 * law->pressure_pa());
}

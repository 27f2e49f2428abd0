// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/membrane.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEST_CASE("the membrane's stresses are those of ISO 17892-9") {
  // 4Et/D = 4 · 1400 kPa · 0.3 mm/70 mm = 24 kPa
  const Membrane membrane(24e3, 0, 0.14, 5e-4, 100e3);
  const double height = 0.14 * 0.9, volume = 5e-4 * 0.97;  // ε₁ = 10 %, ε_v = 3 %
  CHECK(membrane.radial_pa(volume) == Approx(24e3 * 0.01));
  CHECK(membrane.axial_pa(height) == Approx(24e3 * (0.1 + 0.01) - 24e3 * 0.01));
  CHECK(membrane.axial_pa(0.14) == 0);
  const double small = 1e-6;
  CHECK((membrane.axial_pa(height * (1 - small)) - membrane.axial_pa(height)) / small ==
        Approx(membrane.axial_slope_pa(height)));
  CHECK((membrane.radial_pa(volume * (1 - small)) - membrane.radial_pa(volume)) / small ==
        Approx(membrane.radial_slope_pa(volume)));
}

TEST_CASE("penetration is a volume per logarithmic cycle of stress") {
  const Membrane membrane(0, 1.5e-7, 0.14, 5e-4, 100e3);
  CHECK(membrane.pocket_m3(100e3) == 0);
  CHECK(membrane.pocket_m3(10e3) == Approx(1.5e-7));
  CHECK(membrane.pocket_m3(1000e3) == Approx(-1.5e-7));
  CHECK(-(membrane.pocket_m3(50.001e3) - membrane.pocket_m3(49.999e3)) / 2 ==
        Approx(membrane.penetration_compliance(50e3)));
  CHECK(Membrane().pocket_m3(1) == 0);
}

TEST_CASE("the specimen carries what the membrane does not") {
  SpecimenProperties p = bare();
  p.membrane_thickness_m = 0.3e-3;
  p.membrane_young_modulus_pa = 1.4e6;
  const Specimen specimen = loose(sanisand_of_s28(), p);
  const SpecimenState s = run(specimen, specimen.start(), moved(2e-5, Water::drained), 1, 700);
  const double axial = 1 - s.height_m / 0.14;
  const double volumetric = 1 - specimen.volume_m3(s) / specimen.volume_m3(specimen.start());
  REQUIRE(axial == Approx(0.1));
  CHECK(s.pore_pressure == Approx(300e3).epsilon(1e-9));
  CHECK(radial_effective(s) == Approx(100e3 - 24e3 * volumetric / 3).epsilon(1e-9));
  CHECK(specimen.axial_force(s) / specimen.area_m2(s) == Approx(s.material.q() + 24e3 * axial));
}

TEST_CASE("penetration lowers B as its compliance says") {
  SpecimenProperties p = bare();
  p.membrane_penetration_m = 5e-6;
  const Specimen specimen = loose(linear_law(30e6, 0.2), p);
  SpecimenBoundary b;
  b.cell_pressure_rate_pa_per_s = 10;
  const auto step = specimen.advance(specimen.start(), b, 1);
  REQUIRE(accepted(step));
  // V dσ₃′/K + C_m dσ₃′ = 0 with rigid water: the soil does not feel the cell at all.
  CHECK(step.state.pore_pressure == Approx(300010.0).epsilon(1e-12));
  p.water_compressibility = 1 / 2.2e9;
  const Specimen wet = loose(linear_law(30e6, 0.2), p);
  const auto b_step = wet.advance(wet.start(), b, 1);
  const double bulk = 30e6 / (3 * (1 - 0.4)), volume = wet.volume_m3(wet.start());
  const double soft = volume / bulk + wet.membrane().penetration_compliance(100e3);
  const double expected = soft / (soft + wet.water_compliance(wet.start()));
  CHECK((b_step.state.pore_pressure - 300e3) / 10 == Approx(expected).epsilon(1e-6));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/implicit_step.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEST_CASE("stiffness is the slope of the force") {
  const Specimen specimen = loose(GENERATE(inl2_law_of_s28(), sanisand_of_s28()), real());
  const SpecimenTolerance tolerance;
  const SpecimenBoundary b = moved(1e-9, GENERATE(Water::closed, Water::drained));
  const SpecimenState state = run(specimen, specimen.start(), moved(1e-5, b.water.kind), 0.25, 150);
  const SpecimenState next = specimen.advance(state, b, 1).state;
  const double slope =
      (specimen.axial_force(next) - specimen.axial_force(state)) / (state.height_m - next.height_m);
  const ImplicitStep step(specimen, b, tolerance, state.height_m);
  CHECK(step.stiffness(state, 1) == Approx(slope).epsilon(1e-3));
  CHECK(step.stiffness(state, -1) > 1.5 * std::abs(slope));
}

TEST_CASE("an equilibrium is sustained before the peak of the force and not beyond it") {
  const Specimen specimen = loose(GENERATE(inl2_law_of_s28(), sanisand_of_s28()), bare());
  const SpecimenTolerance tolerance;
  SpecimenBoundary dead = dead_load(0, 0);
  const ImplicitStep step(specimen, dead, tolerance, specimen.start().height_m);
  const SpecimenState before = run(specimen, specimen.start(), moved(1e-5), 0.25, 100);
  CHECK(step.sustains(before));
  const SpecimenState beyond = past_peak(specimen);
  CHECK_FALSE(step.sustains(beyond));
  CHECK(step.stiffness(beyond, 1) < 0);
  // A spring stiffer than the specimen softens holds it.
  dead.axis.stiffness_n_per_m = 1.1 * -step.stiffness(beyond, 1);
  CHECK(step.sustains(beyond));
  dead.axis.stiffness_n_per_m = 0.9 * -step.stiffness(beyond, 1);
  CHECK_FALSE(step.sustains(beyond));
}

TEST_CASE("an implicit step leaves the given state alone") {
  const Specimen specimen = loose(sanisand_of_s28(), bare());
  const SpecimenTolerance tolerance;
  const SpecimenState start = specimen.start();
  const SpecimenBoundary b = moved(1e-5);
  const auto step = ImplicitStep(specimen, b, tolerance, start.height_m).take(start, 0, 2);
  CHECK(step.state.height_m == Approx(0.14 - 2e-5).epsilon(1e-14));
  CHECK(step.done_s == 2);
  CHECK(start.height_m == 0.14);
  CHECK(start.material.q() == 0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/boundary.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEST_CASE("a force is met at the end of a step, however long") {
  const Specimen specimen = loose(sanisand_of_s28(), GENERATE(bare(), real()));
  SpecimenBoundary b = moved(0, Water::drained);
  b.axis.kind = Axis::force;
  b.axis.force_n = 30;
  b.axis.force_rate_n_per_s = 2;
  const auto step = specimen.advance(specimen.start(), b, 10);
  REQUIRE(accepted(step));
  CHECK(specimen.axial_force(step.state) == Approx(50).epsilon(1e-9));
  CHECK(step.state.applied_force_n == Approx(50).epsilon(1e-9));
  CHECK(step.state.velocity_m_per_s * 10 == Approx(specimen.displacement_m(step.state)));
}

TEST_CASE("a spring is in series, and a stiff one is rigid") {
  const Specimen specimen = loose(sanisand_of_s28(), bare());
  SpecimenBoundary b;
  b.axis.kind = Axis::force;
  const auto driven = [&](double k) {
    SpecimenState state = specimen.start();
    b.axis.stiffness_n_per_m = k;
    b.axis.force_rate_n_per_s = k * 1e-6;
    for (int i = 0; i < 100; ++i) {
      b.axis.force_n = state.applied_force_n;
      state = specimen.advance(state, b, 0.5).state;
    }
    return state;
  };
  const SpecimenState soft = driven(1e6);
  // Way of the crosshead = specimen + spring.
  CHECK(specimen.displacement_m(soft) + specimen.axial_force(soft) / 1e6 ==
        Approx(50e-6).epsilon(1e-9));
  const SpecimenState rigid = run(specimen, specimen.start(), moved(1e-6), 0.5, 100);
  CHECK(driven(1e15).material.q() == Approx(rigid.material.q()).epsilon(1e-7));
  CHECK(soft.material.q() < 0.9 * rigid.material.q());
}

TEST_CASE("a drive that follows the area holds q, one that does not holds F") {
  const Specimen specimen = loose(sanisand_of_s28(), bare());
  SpecimenState state = run(specimen, specimen.start(), moved(2e-6, Water::drained), 1, 60);
  const double q = state.material.q(), force = specimen.axial_force(state);
  REQUIRE(q > 10e3);
  const SpecimenState held = run(specimen, state, constant_q(q, -50, Water::drained), 1, 400);
  CHECK(held.material.q() == Approx(q).epsilon(1e-10));
  SpecimenBoundary dead = constant_q(0, -50, Water::drained);
  dead.axis.force_n = force;
  const SpecimenState loaded = run(specimen, state, dead, 1, 400);
  CHECK(specimen.axial_force(loaded) == Approx(force).epsilon(1e-9));
  CHECK(std::abs(loaded.material.q() / q - 1) > 1e-7);
}

TEST_CASE("without a piston nothing stands on the specimen, with a membrane neither") {
  const Specimen specimen = loose(sanisand_of_s28(), real());
  SpecimenBoundary b = moved(0, Water::drained);
  b.axis.kind = Axis::free;
  b.cell_pressure_rate_pa_per_s = 500;
  const SpecimenState state = run(specimen, specimen.start(), b, 1, 200);
  CHECK(std::abs(specimen.axial_force(state)) < 1e-8);
  CHECK(state.material.q() < 0);  // the membrane is compressed along the axis
}

TEST_CASE("a drive that cannot be is refused") {
  const Specimen specimen = loose(sanisand_of_s28(), bare());
  SpecimenBoundary b = dead_load(0, 0);
  b.axis.impulse_n_s = 1;
  const auto without_mass = specimen.advance(specimen.start(), b, 1);
  CHECK(without_mass.outcome == StepOutcome::failed);
  CHECK(without_mass.message ==
        "an impulse or inertia needs an axis driven by a force, with a mass above 0");
  b = dead_load(0, 1);
  b.axis.stiffness_n_per_m = -1;
  CHECK(specimen.advance(specimen.start(), b, 1).outcome == StepOutcome::failed);
}

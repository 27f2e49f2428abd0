// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/quasi_static.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEST_CASE("a stop holds the cap until the drive pulls away, at either end of the travel") {
  const double way = GENERATE(1, -1);
  const Specimen specimen = loose(sanisand_of_s28(), bare());
  SpecimenBoundary b = moved(0, Water::drained);
  b.axis.kind = Axis::force;
  b.axis.travel_m = 1e-4;
  b.axis.force_n = way * 200;
  auto step = specimen.advance(specimen.start(), b, 1);
  REQUIRE(accepted(step));
  CHECK(step.at_stop);
  CHECK(specimen.displacement_m(step.state) == Approx(way * 1e-4).epsilon(1e-12));
  const double carried = specimen.axial_force(step.state);
  CHECK(way * carried < 150);
  CHECK(way * carried > 0);
  CHECK(step.state.applied_force_n == way * 200);

  step = specimen.advance(step.state, b, 1);
  CHECK(step.at_stop);
  CHECK(specimen.axial_force(step.state) == Approx(carried).epsilon(1e-9));

  b.axis.force_n = 0.5 * carried;
  step = specimen.advance(step.state, b, 1);
  CHECK_FALSE(step.at_stop);
  CHECK(specimen.axial_force(step.state) == Approx(0.5 * carried).epsilon(1e-9));
  CHECK(way * specimen.displacement_m(step.state) < 1e-4);
}

TEST_CASE("a resistance flows as the lag over it says") {
  SpecimenProperties p = bare();
  p.drainage_resistance = 1e10;
  const Specimen specimen = loose(linear_law(30e6, 0.2), p);
  SpecimenBoundary b = moved(0, Water::drained);
  b.axis.kind = Axis::free;
  b.water.back_pressure_pa = 290e3;
  SpecimenTolerance fine;
  fine.pore_pressure_pa = 0.5;
  // u − u_b falls as exp(−t/τ), τ = R V/K with rigid water.
  const double bulk = 30e6 / (3 * (1 - 0.4));
  const double tau = 1e10 * specimen.volume_m3(specimen.start()) / bulk;
  const auto step = specimen.advance(specimen.start(), b, tau, fine);
  REQUIRE(accepted(step));
  CHECK(step.state.pore_pressure - 290e3 == Approx(10e3 * std::exp(-1)).epsilon(1e-2));
  CHECK(step.state.drained_volume_m3 ==
        Approx(specimen.volume_m3(specimen.start()) - specimen.volume_m3(step.state)));
  CHECK(step.substeps > 10);
}

TEST_CASE("what drainage holds up only slowly is lost to a mass") {
  SpecimenProperties p = bare();
  p.drainage_resistance = 1e11;
  const Specimen specimen = loose(sanisand_of_s28(), p);
  SpecimenState state = specimen.start();
  for (int i = 0; i < 5000 && state.material.q() < 40e3; ++i)
    state = specimen.advance(state, moved(5e-7, Water::drained), 1).state;
  SpecimenBoundary b = constant_q(state.material.q(), -50, Water::drained);
  b.axis.mass_kg = 5;
  b.axis.travel_m = 0.02;
  SpecimenStep step;
  int ran_away_at = 0;
  for (int i = 0; i < 4000 && !step.at_stop; ++i) {
    step = specimen.advance(state, b, 0.25);
    REQUIRE(accepted(step));
    state = step.state;
    if (step.ran_away && ran_away_at == 0) {
      ran_away_at = i;
      CHECK(state.material.q() / state.material.p() == Approx(0.59).margin(0.01));
    }
  }
  CHECK(ran_away_at > 0);
  CHECK(step.at_stop);
  CHECK(state.run_away.end == RunAway::End::end_of_travel);
  CHECK(state.run_away.largest_kinetic_energy_j > 0.1);
  CHECK(state.pore_pressure > 350e3);  // it liquefied: the water had no time to leave
}

TEST_CASE("a step that asks for more of the law's integration than allowed ends as where it ends") {
  SpecimenProperties p = bare();
  p.drainage_resistance = 1e10;
  const Specimen specimen = loose(sanisand_of_s28(), p);
  const SpecimenBoundary b = moved(1e-5, Water::drained);
  const auto whole = specimen.advance(specimen.start(), b, 10);
  REQUIRE(accepted(whole));
  SpecimenTolerance little;
  little.law_steps = whole.law_steps / 2;
  const auto cut = specimen.advance(specimen.start(), b, 10, little);
  CHECK(cut.outcome == StepOutcome::failed);
  CHECK(cut.law_ended);
  CHECK(cut.message.find("ever shorter steps") != std::string::npos);
  CHECK(cut.done_s < 10);
  CHECK(cut.done_s > 0);
  little.law_steps = whole.law_steps;
  CHECK(accepted(specimen.advance(specimen.start(), b, 10, little)));
}

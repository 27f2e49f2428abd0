// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/run_away_log.hpp"

#include <catch2/catch.hpp>

using namespace triax;
using Catch::Contains;

TEST_CASE("a run-away is told at its start and at its end, with what it came to") {
  lab::RunAwayLog log;
  sim::SpecimenState state;
  CHECK(log.watch(10, state).empty());
  state.run_away.count = 1;
  state.run_away.under_way = true;
  state.run_away.elapsed_s = 0.1;
  const lab::Truth start{
      .axial_strain = 0.02, .q_pa = 60e3, .p_eff_pa = 90e3, .pore_pressure_pa = 510e3};
  CHECK_THAT(log.watch(20, state, start), Contains("equilibrium lost at 19.9"));
  REQUIRE(log.all().size() == 1);
  CHECK_FALSE(log.all()[0].end_s);
  CHECK_FALSE(log.all()[0].kinetic_energy_j);
  state.run_away.elapsed_s = 0.25;
  state.run_away.under_way = false;
  state.run_away.end = sim::RunAway::End::arrested;
  state.run_away.largest_kinetic_energy_j = 0.5;
  state.run_away.largest_at_s = 0.2;
  state.run_away.compared_at_s = 0.01;
  state.run_away.kinetic_energy_j = 1.5e-4;
  state.run_away.initial_kinetic_energy_j = 0.5e-4;
  state.run_away.second_order_work_j = -2e-4;
  state.run_away.stiffness_at_start_n_per_m = state.run_away.secant_stiffness_n_per_m = -1e5;
  CHECK_THAT(log.watch(20.25, state), Contains("0.5 J") && Contains("new equilibrium"));
  const lab::RunAwayTruth& truth = log.all()[0];
  CHECK(truth.start_s == Approx(19.9));
  CHECK(truth.axial_strain == 0.02);
  CHECK(truth.q_pa == 60e3);
  CHECK(truth.p_eff_pa == 90e3);
  CHECK(truth.pore_pressure_pa == 510e3);
  CHECK(*truth.end_s == Approx(20.15));
  CHECK(truth.largest_at_s == Approx(20.1));
  CHECK(*truth.kinetic_energy_j == Approx(1e-4));
  CHECK(*truth.expected_ratio == Approx(1));
  CHECK(*truth.second_order_work_j == -2e-4);
  CHECK(truth.end == lab::RunAwayEnd::new_equilibrium);
  CHECK(log.watch(21, state).empty());
  state.run_away.count = 2;
  CHECK_THAT(log.watch(30, state), Contains("runaway of the cap"));
  REQUIRE(log.all().size() == 2);
  CHECK_FALSE(log.all()[1].q_pa);
}

TEST_CASE("a specimen that slips without end does not fill the memory") {
  lab::RunAwayLog log;
  sim::SpecimenState state;
  for (int i = 1; i < 1000; ++i) {
    state.run_away.count = i;
    log.watch(i, state);
  }
  CHECK(log.all().size() == lab::RunAwayLog::kMost);
}

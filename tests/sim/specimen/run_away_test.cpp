// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/run_away.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

RunAway let_go(const Specimen& specimen, SpecimenState state, SpecimenBoundary b, double share) {
  SpecimenTolerance tolerance;
  tolerance.inertial_substep = share;
  for (int i = 0; i < 20; ++i) {
    const auto step = specimen.advance(state, b, 0.25, tolerance);
    REQUIRE(accepted(step));
    state = step.state;
    b.axis.impulse_n_s = 0;
    b.axis.inertial = false;
    if (!state.run_away.under_way) break;
  }
  REQUIRE(state.run_away.compared_at_s > 0);
  return state.run_away;
}

}  // namespace

// Eq. (5) to 1 %, the better the smaller substep and increment: from equilibria that displacement
// (undrained) or drainage (constant q) held, handed over to dead load.
TEST_CASE("kinetic energy at the start of a run-away is half the second-order work, negative") {
  const LawPointer law = GENERATE(inl2_law_of_s28(), sanisand_of_s28());
  const bool undrained = GENERATE(true, false);
  const SpecimenProperties properties = GENERATE(bare(), real());
  const double mass = GENERATE(1.0, 50.0);
  const Specimen specimen = loose(law, properties);
  const SpecimenState start = undrained ? past_peak(specimen) : past_onset(specimen, 40e3, 0.64);
  SpecimenBoundary b = dead_load(specimen.axial_force(start), mass);
  const double speed = 1e-6;
  const auto away = [&](double perturbation, double share) {
    b.axis.impulse_n_s = perturbation * speed * mass;
    return let_go(specimen, start, b, share);
  };
  const RunAway coarse = away(16, 0.1), fine = away(4, 0.05), finest = away(1, 0.025);
  CHECK(coarse.stiffness_at_start_n_per_m < 0);
  CHECK(std::abs(finest.ratio() - 1) < 1e-3);
  CHECK(std::abs(fine.ratio() - 1) < 0.01);
  CHECK(std::abs(coarse.ratio() - 1) < 0.05);
  CHECK(std::abs(finest.ratio() - 1) < 0.5 * std::abs(coarse.ratio() - 1));
  CHECK(finest.ratio() == Approx(finest.expected_ratio()).epsilon(1e-3));
  CHECK(finest.second_order_work_j < 0);
  CHECK(std::abs(finest.second_order_work_j) < std::abs(coarse.second_order_work_j));
}

TEST_CASE("a small load step does the same, its own work taken off") {
  const Specimen specimen = loose(GENERATE(inl2_law_of_s28(), sanisand_of_s28()), real());
  const SpecimenState start = past_peak(specimen);
  SpecimenBoundary b = dead_load(specimen.axial_force(start) + 1e-3, 5);
  b.axis.inertial = true;
  const RunAway found = let_go(specimen, start, b, 0.02);
  CHECK(found.first_order_work_j > 0);
  CHECK(found.ratio() == Approx(1).margin(0.01));
}

TEST_CASE("a spring softer than the specimen softens adds its own second-order work") {
  const Specimen specimen = loose(sanisand_of_s28(), real());
  const SpecimenState start = past_peak(specimen);
  SpecimenBoundary b = dead_load(specimen.axial_force(start), 5);
  b.axis.stiffness_n_per_m = 5e3;
  b.axis.impulse_n_s = 5e-6;
  SpecimenTolerance tolerance;
  tolerance.inertial_substep = 0.02;
  SpecimenState state = start;
  for (int i = 0; i < 10 && state.run_away.compared_at_s == 0; ++i) {
    const auto step = specimen.advance(state, b, 0.25, tolerance);
    REQUIRE(accepted(step));
    state = step.state;
    b.axis.impulse_n_s = 0;
    b.axis.force_n = state.applied_force_n;
  }
  REQUIRE(state.run_away.compared_at_s > 0);
  CHECK(state.run_away.ratio() == Approx(1).margin(5e-3));
}

TEST_CASE("from a limit point third order leads, and the ratio goes to two thirds") {
  const Specimen specimen = loose(GENERATE(inl2_law_of_s28(), sanisand_of_s28()), bare());
  // Loads that rise until they are not carried any longer, ever more slowly.
  const auto ramp = [&](double rate) {
    SpecimenState state = run(specimen, specimen.start(), moved(1e-5), 0.25, 120);
    SpecimenBoundary b = dead_load(specimen.axial_force(state), 5);
    b.axis.force_rate_n_per_s = rate;
    for (int i = 0; i < 200000 && !(state.run_away.compared_at_s > 0); ++i) {
      const auto step = specimen.advance(state, b, 0.25);
      REQUIRE(accepted(step));
      state = step.state;
      b.axis.force_n += rate * 0.25;
    }
    REQUIRE(state.run_away.compared_at_s > 0);
    return state.run_away;
  };
  const RunAway fast = ramp(0.5), slow = ramp(0.02);
  CHECK(std::abs(slow.stiffness_at_start_n_per_m) < 0.01 * std::abs(slow.secant_stiffness_n_per_m));
  CHECK(slow.expected_ratio() == Approx(2.0 / 3).margin(0.01));
  CHECK(slow.ratio() == Approx(2.0 / 3).margin(0.03));
  CHECK(std::abs(slow.ratio() - 2.0 / 3) < std::abs(fast.ratio() - 2.0 / 3));
}

TEST_CASE("ratio and what is expected of it follow from the record") {
  RunAway r;
  r.kinetic_energy_j = 6;
  r.initial_kinetic_energy_j = 0.5;
  r.first_order_work_j = 1;
  r.damping_work_j = 0.5;
  r.second_order_work_j = -10;
  CHECK(r.ratio() == Approx(1));
  r.stiffness_at_start_n_per_m = r.secant_stiffness_n_per_m = -4;
  CHECK(r.expected_ratio() == Approx(1));
  r.stiffness_at_start_n_per_m = 0;
  CHECK(r.expected_ratio() == Approx(2.0 / 3));
}

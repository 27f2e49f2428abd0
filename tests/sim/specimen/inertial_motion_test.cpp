// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/inertial_motion.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

SpecimenBoundary load_step(const Specimen& specimen, const SpecimenState& state, double step_n,
                           double mass_kg) {
  SpecimenBoundary b = dead_load(specimen.axial_force(state) + step_n, mass_kg);
  b.water.kind = Water::drained;
  b.water.back_pressure_pa = 300e3;
  b.axis.inertial = true;
  return b;
}

double kinetic(const SpecimenState& s, double mass) {
  return 0.5 * mass * s.velocity_m_per_s * s.velocity_m_per_s;
}

}  // namespace

TEST_CASE("an elastic specimen vibrates as a mass on a spring does") {
  const Specimen specimen = loose(linear_law(30e6, 0.2), bare());
  const double k = 30e6 * specimen.area_m2(specimen.start()) / 0.14, m = 5;
  const double omega = std::sqrt(k / m), period = 2 * std::numbers::pi / omega;
  const SpecimenBoundary b = load_step(specimen, specimen.start(), 40, m);
  const double still = 40 / k;
  const auto half = specimen.advance(specimen.start(), b, period / 2);
  REQUIRE(accepted(half));
  CHECK(specimen.displacement_m(half.state) == Approx(2 * still).epsilon(2e-3));
  CHECK(half.state.run_away.under_way);
  CHECK(half.state.run_away.largest_kinetic_energy_j == Approx(0.5 * 40 * still).epsilon(2e-3));
  CHECK(half.state.run_away.largest_at_s == Approx(period / 4).epsilon(0.02));
  CHECK(std::abs(half.work.balance()) < 1e-3 * half.work.axial);
  SpecimenBoundary on = b;
  on.axis.inertial = false;
  const auto whole = specimen.advance(half.state, on, period / 2);
  CHECK(specimen.displacement_m(whole.state) == Approx(0).margin(4e-3 * still));
  CHECK(whole.state.run_away.count == 1);
}

TEST_CASE("a damper brings it to rest where the load is carried") {
  const Specimen specimen = loose(linear_law(30e6, 0.2), bare());
  const double k = 30e6 * specimen.area_m2(specimen.start()) / 0.14;
  SpecimenBoundary b = load_step(specimen, specimen.start(), 40, 5);
  b.axis.damping_n_s_per_m = 0.4 * std::sqrt(5 * k);
  SpecimenStep step = specimen.advance(specimen.start(), b, 0.25);
  REQUIRE(accepted(step));
  CHECK(step.state.run_away.end == RunAway::End::arrested);
  CHECK_FALSE(step.state.run_away.under_way);
  // Damper and, of what was left, the rest take what the load gave beyond the spring of the soil.
  CHECK(step.work.damping + step.work.stop == Approx(0.5 * 40 * 40 / k).epsilon(0.01));
  CHECK(step.work.damping > 10 * step.work.stop);
  CHECK(step.done_s == 0.25);
  CHECK(specimen.axial_force(step.state) == Approx(40).epsilon(1e-9));
  CHECK(step.state.velocity_m_per_s == Approx(0).margin(1e-4));
  // From here on a step costs one integration again.
  b.axis.inertial = false;
  CHECK(specimen.advance(step.state, b, 0.25).substeps == 1);
}

TEST_CASE("energy closes in motion, the better the shorter the substep") {
  const Specimen specimen = loose(sanisand_of_s28(), real());
  const SpecimenState start = past_peak(specimen);
  SpecimenBoundary b = dead_load(specimen.axial_force(start), 5);
  b.axis.impulse_n_s = 1e-3;
  SpecimenTolerance fine;
  const auto missed = [&](double share) {
    fine.inertial_substep = share;
    const auto step = specimen.advance(start, b, 0.1, fine);
    REQUIRE(accepted(step));
    REQUIRE(step.ran_away);
    REQUIRE(step.work.kinetic > 1e-3);
    CHECK(std::abs(specimen.water_imbalance_m3(step.state)) <
          1e-12 * specimen.volume_m3(step.state));
    return std::abs(step.work.balance()) / step.work.kinetic;
  };
  const double coarse = missed(0.1), finer = missed(0.05), finest = missed(0.025);
  CHECK(coarse < 1e-2);
  CHECK(finer < 0.35 * coarse);
  CHECK(finest < 0.35 * finer);
}

TEST_CASE("a run-away ends at either end of travel, and the stop takes the energy") {
  const Specimen specimen = loose(GENERATE(inl2_law_of_s28(), sanisand_of_s28()), real());
  const double way = GENERATE(1, -1);
  SpecimenState state = past_peak(specimen, way);
  SpecimenBoundary b = dead_load(specimen.axial_force(state), 5);
  b.axis.impulse_n_s = way * 1e-4;
  SpecimenStep step;
  for (int i = 0; i < 20 && !step.at_stop; ++i) {
    step = specimen.advance(state, b, 0.25);
    REQUIRE(accepted(step));
    state = step.state;
    b.axis.impulse_n_s = 0;
  }
  CHECK(step.at_stop);
  CHECK(state.run_away.end == RunAway::End::end_of_travel);
  CHECK(specimen.displacement_m(state) == Approx(way * 0.03).epsilon(1e-12));
  CHECK(step.work.stop == Approx(state.run_away.largest_kinetic_energy_j).epsilon(0.05));
  CHECK(state.velocity_m_per_s == 0);
  CHECK(state.applied_force_n == Approx(b.axis.force_n));
  step = specimen.advance(state, b, 0.25);
  CHECK(step.at_stop);
  CHECK(step.substeps == 1);
  CHECK(step.state.height_m == Approx(state.height_m).epsilon(1e-14));
}

TEST_CASE("a specimen that regains strength arrests, and then carries more") {
  const Specimen specimen = loose(sanisand_of_s28(), real(), 0.85);
  SpecimenState state = specimen.start();
  SpecimenBoundary b = dead_load(0, 5);
  b.axis.force_rate_n_per_s = 0.5;
  int steps_in_motion = 0;
  double at_arrest = 0;
  for (int i = 0; i < 2000; ++i) {
    b.axis.force_n = 0.5 * 0.25 * i;
    const auto step = specimen.advance(state, b, 0.25);
    REQUIRE(accepted(step));
    state = step.state;
    if (step.ran_away) ++steps_in_motion;
    if (state.run_away.count == 1 && !state.run_away.under_way && at_arrest == 0)
      at_arrest = specimen.axial_force(state);
  }
  CHECK(state.run_away.count == 1);
  CHECK(state.run_away.end == RunAway::End::arrested);
  CHECK(steps_in_motion >= 1);
  CHECK(steps_in_motion < 10);
  CHECK(state.run_away.largest_kinetic_energy_j > 1e-3);
  CHECK(at_arrest > 100);
  CHECK(specimen.axial_force(state) == Approx(0.5 * 0.25 * 2000).epsilon(1e-9));
}

TEST_CASE("the same small perturbation settles before the peak and collapses beyond it") {
  const Specimen specimen = loose(GENERATE(inl2_law_of_s28(), sanisand_of_s28()), real());
  const SpecimenState before = run(specimen, specimen.start(), moved(1e-5), 0.25, 60);
  const SpecimenState beyond = past_peak(specimen);
  const bool impulse = GENERATE(true, false);
  const auto perturbed = [&](SpecimenState state) {
    SpecimenBoundary b = dead_load(specimen.axial_force(state), 5);
    if (impulse)
      b.axis.impulse_n_s = 0.02;  // 4e-5 J
    else
      b.axis.force_n += 1;
    b.axis.inertial = !impulse;
    for (int i = 0; i < 12; ++i) {
      const auto step = specimen.advance(state, b, 0.25);
      REQUIRE(accepted(step));
      state = step.state;
      b.axis.impulse_n_s = 0;
      b.axis.inertial = false;
    }
    return state;
  };
  const SpecimenState settled = perturbed(before), collapsed = perturbed(beyond);
  CHECK(settled.run_away.end == RunAway::End::arrested);
  CHECK(before.height_m - settled.height_m < 1e-4);
  CHECK(settled.run_away.largest_kinetic_energy_j < 1e-4);
  CHECK(collapsed.run_away.end == RunAway::End::end_of_travel);
  CHECK(collapsed.run_away.largest_kinetic_energy_j > 0.1);
}

TEST_CASE("another drive catches a cap in motion") {
  const Specimen specimen = loose(sanisand_of_s28(), bare());
  const SpecimenState start = past_peak(specimen);
  SpecimenBoundary b = dead_load(specimen.axial_force(start), 5);
  b.axis.impulse_n_s = 1e-3;
  const SpecimenState flying = specimen.advance(start, b, 0.1).state;
  REQUIRE(flying.run_away.under_way);
  REQUIRE(kinetic(flying, 5) > 0);
  const auto caught = specimen.advance(flying, moved(1e-6), 0.25);
  REQUIRE(accepted(caught));
  CHECK_FALSE(caught.state.run_away.under_way);
  CHECK(caught.state.run_away.end == RunAway::End::arrested);
  CHECK(caught.state.velocity_m_per_s == Approx(1e-6));
}

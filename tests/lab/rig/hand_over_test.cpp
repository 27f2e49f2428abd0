// SPDX-License-Identifier: GPL-3.0-or-later
// One stage takes over from the other in mid-test, and what loads decide then.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;

namespace {

const std::string kMovingFrame =
    "water_bulk_modulus_GPa = 2.2\nsystem_compliance_mm3_per_kPa = 0.5\n[rig.frame]\n"
    "travel_mm = 20.0\nmoving_mass_kg = 5.0\n";

std::string displaced(const std::string& end) {
  return shear_stage("closed", "displacement", "axial_rate_mm_per_min = 0.1", end);
}
std::string sprung(double n_per_mm, const std::string& end) {
  return shear_stage(
      "closed", "spring",
      "axial_rate_mm_per_min = 0.1\nspring_stiffness_N_per_mm = " + std::to_string(n_per_mm), end);
}
const std::string kMinute = R"("time_min", above = 1.0)";
const std::string kPastPeak = R"("axial_strain_pct", above = 0.7)";

}  // namespace

TEST_CASE("displacement, dead load, load and spring take over without a jump in force") {
  const std::string stages =
      displaced(R"("q_kPa", above = 20.0)") + shear_stage("closed", "dead_load", "", kMinute) +
      displaced(R"("q_kPa", above = 25.0)") + sprung(200, kMinute) +
      shear_stage("closed", "load", "load_rate_N_per_min = 2.0", kMinute) + displaced(kMinute);
  for (const std::string& rig : {kIdealFrame, kMovingFrame}) {
    INFO(rig);
    VirtualRig virtual_rig(rig_programme(stages, rig));
    const auto readings = all_readings(virtual_rig);
    REQUIRE(readings.back().stage == 6);
    for (std::size_t i = 1; i < readings.size(); ++i) {
      // The fastest is 0.1 mm/min on a specimen of some 200 N/mm: less than 0.5 N a tick.
      const double jump =
          readings[i][Quantity::axial_force] - readings[i - 1][Quantity::axial_force];
      CHECK(std::fabs(jump) < 0.5);
    }
    for (const Reading& r : of_stage(readings, 2))
      CHECK(r[Quantity::axial_force] ==
            Approx(of_stage(readings, 2)[0][Quantity::axial_force]).epsilon(1e-6));
    CHECK(virtual_rig.truth()->run_aways.empty());
    CHECK(virtual_rig.header().warnings.empty());
  }
}

TEST_CASE("past the peak a dead load runs away, and Eq. 5 holds for what it sets free") {
  VirtualRig rig(rig_programme(
      displaced(kPastPeak) + shear_stage("closed", "dead_load", "impulse_N_s = 0.001", kMinute),
      kMovingFrame));
  const auto readings = all_readings(rig);
  const Truth truth = *rig.truth();
  REQUIRE(truth.run_aways.size() == 1);
  const RunAwayTruth& fall = truth.run_aways[0];
  CHECK(fall.largest_kinetic_energy_j > 0.1);
  CHECK(*fall.second_order_work_j < 0);
  CHECK(2 * *fall.kinetic_energy_j / -*fall.second_order_work_j == Approx(1).margin(0.05));
  CHECK(fall.end == RunAwayEnd::end_of_travel);
  CHECK(*fall.end_s > fall.start_s);
  CHECK(readings.back()[Quantity::axial_displacement] == Approx(0.02).epsilon(1e-9));
}

TEST_CASE("a spring stiffer than the softening specimen holds it, a softer one does not") {
  const auto run_aways = [](double n_per_mm) {
    VirtualRig rig(
        rig_programme(displaced(kPastPeak) + sprung(n_per_mm, R"("axial_strain_pct", above = 2.0)"),
                      kMovingFrame));
    const auto readings = all_readings(rig);
    CHECK(readings.back().stage == 2);
    return rig.truth()->run_aways;
  };
  CHECK(run_aways(2000).empty());
  const auto fallen = run_aways(2);
  REQUIRE(fallen.size() == 1);
  CHECK(fallen[0].largest_kinetic_energy_j > 1e-3);
}

TEST_CASE("a blow settles before the peak of q and ends the test after it") {
  VirtualRig rig(load_programme("samples/programmes/perturbed.toml"));
  const auto readings = all_readings(rig);
  const Truth truth = *rig.truth();
  const auto before = of_stage(readings, 5), after = of_stage(readings, 7);
  REQUIRE(before.size() > 200);
  REQUIRE_FALSE(after.empty());
  // Settled: within 0.1 mm of where it was, and the next stage came.
  CHECK(std::fabs(before.back()[Quantity::axial_displacement] -
                  before.front()[Quantity::axial_displacement]) < 1e-4);
  REQUIRE(truth.run_aways.size() == 2);
  CHECK(truth.run_aways[0].end == RunAwayEnd::new_equilibrium);
  CHECK(truth.run_aways[0].start_s < before.back().time_s);
  CHECK(truth.run_aways[1].end == RunAwayEnd::end_of_travel);
  CHECK(truth.run_aways[1].start_s > before.back().time_s);
  CHECK(truth.run_aways[1].largest_kinetic_energy_j >
        100 * truth.run_aways[0].largest_kinetic_energy_j);
}

TEST_CASE("moist sand is saturated by ramps: B of at least 0.96 before it is sheared") {
  Programme programme = load_programme("samples/programmes/icu_saturated.toml");
  VirtualRig rig(programme);
  std::vector<double> b;
  double cell = 0, pore = 0;
  int stage = 0;
  const auto checks = [&](int number) {
    return number > 0 && rig.header().stage(number)->role == StageRole::b_check;
  };
  double last_b = 0;
  for (Reading r; rig.next(r);) {
    const auto& state = rig.specimen_state();
    if (stage != r.stage) {
      if (checks(stage)) b.push_back(last_b);
      stage = r.stage;
    } else if (checks(stage) && state.cell_pressure - cell > 1e3) {
      last_b = (state.pore_pressure - pore) / (state.cell_pressure - cell);
    }
    if (!checks(stage)) {
      cell = state.cell_pressure;
      pore = state.pore_pressure;
    }
  }
  REQUIRE(b.size() == 4);
  CHECK(std::ranges::is_sorted(b));
  CHECK(b.front() < 0.8);
  CHECK(b.back() >= 0.96);
  CHECK(rig.plant().specimen().saturation(rig.specimen_state()) > 0.999);
  CHECK(rig.truth()->lost_sustainability);
}

TEST_CASE("a stage ends by B, by a rate that has died away, by a pressure that reads wrong") {
  // B of a saturated specimen is above 0.9 as soon as the cell pressure has moved by 5 kPa.
  VirtualRig by_b(
      rig_programme(stage_text("b_check", "closed", "free", "cell_rate_kPa_per_min = 30.0",
                               R"("b_value", above = 0.9)"),
                    kMovingFrame));
  const auto checked = all_readings(by_b);
  CHECK(checked.back().time_s == Approx(10).margin(0.6));
  CHECK(by_b.header().warnings.empty());

  VirtualRig by_rate(
      rig_programme(stage_text("consolidation", "open", "free",
                               "cell_rate_kPa_per_min = 60.0\ncell_target_kPa = 500.0",
                               R"("volume_rate_mm3_per_min", below = 5.0)"),
                    "drainage_resistance_kPa_s_per_mm3 = 5.0\n" + kIdealFrame, 1.0));
  const auto drained = all_readings(by_rate);
  CHECK(by_rate.header().warnings.empty());
  CHECK(drained.back().time_s > 60);
  REQUIRE(drained.size() > 60);
  const double last = drained.back()[Quantity::back_volume],
               half_a_minute_ago = drained[drained.size() - 31][Quantity::back_volume];
  CHECK(std::fabs(last - half_a_minute_ago) < 5e-9);

  VirtualRig offset(
      rig_programme(stage_text("consolidation", "open", "free",
                               "cell_rate_kPa_per_min = 60.0\ncell_target_kPa = 430.0",
                               R"("cell_pressure_kPa", above = 430.0)"),
                    kIdealFrame + "[rig.transducers.cell_pressure]\noffset_kPa = -2.0\n"));
  const auto ramp = all_readings(offset);
  CHECK(ramp.back().time_s == Approx(30).margin(0.6));
  CHECK(ramp.back()[Quantity::cell_pressure] == Approx(428e3).epsilon(1e-6));
  CHECK(offset.header().warnings.empty());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/guard_stages.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;
using Catch::Contains;

namespace {

const std::string kWithMass =
    "water_bulk_modulus_GPa = 2.2\nsystem_compliance_mm3_per_kPa = 0.5\n[rig.frame]\n"
    "travel_mm = 20.0\nmoving_mass_kg = 5.0\n";
const std::string kFar = R"("axial_strain_pct", above = 10.0)";

std::string by_load(double n_per_min) {
  return shear_stage("closed", "load", "load_rate_N_per_min = " + std::to_string(n_per_min),
                     n_per_min > 0 ? kFar : R"("axial_strain_pct", below = -10.0)");
}
std::string guard(const std::string& keys) { return "[guard]\non = \"imminent\"\n" + keys; }
const std::string kHandOver =
    guard("action = \"hand_over\"\nrate_mm_per_min = 0.5\nfurther_strain_pct = 1.0\n");

std::optional<std::string> heed(VirtualRig& rig, WarningLevel level) {
  rig.heed(level);
  return rig.guarded();
}

struct Guarded {
  std::vector<Reading> readings;
  std::size_t acted = 0;  ///< readings by then; 0: never
  std::string done;
};

/// Calls the guard where the axial force in N has come to `force`.
Guarded run_guarded(VirtualRig& rig, double force) {
  Guarded all;
  for (Reading r; rig.next(r);) {
    all.readings.push_back(r);
    if (all.acted > 0 || std::fabs(r[Quantity::axial_force]) < force) continue;
    if (const auto done = heed(rig, WarningLevel::imminent)) {
      all.done = *done;
      all.acted = all.readings.size();
    }
  }
  return all;
}

double strain_between(const Reading& a, const Reading& b) {
  return (b[Quantity::axial_displacement] - a[Quantity::axial_displacement]) / 0.14;
}

}  // namespace

TEST_CASE("a load that is handed over stays, and the crosshead goes on past its peak") {
  const std::string stages = by_load(60);
  VirtualRig unguarded(rig_programme(stages, kWithMass));
  CHECK(run_guarded(unguarded, 1e9).readings.size() > 100);
  REQUIRE(unguarded.truth()->run_aways.size() == 1);

  VirtualRig rig(rig_programme(stages + kHandOver, kWithMass));
  const Guarded all = run_guarded(rig, 160);
  REQUIRE(all.acted > 0);
  CHECK(all.done == "switched to displacement at 0.5 mm/min");
  CHECK(rig.truth()->run_aways.empty());
  CHECK(rig.truth()->lost_sustainability);  // it was led past the peak
  const Reading& at = all.readings[all.acted - 1];
  CHECK(at.stage == 1);
  REQUIRE(all.readings.size() > all.acted + 100);
  for (std::size_t i = all.acted; i < all.readings.size(); ++i) {
    CHECK(all.readings[i].stage == 2);
    const double jump =
        all.readings[i][Quantity::axial_force] - all.readings[i - 1][Quantity::axial_force];
    CHECK(std::fabs(jump) < 2);
    const double lapse = all.readings[i].time_s - at.time_s;
    CHECK(strain_between(at, all.readings[i]) == Approx(0.5e-3 / 60 * lapse / 0.14).margin(1e-5));
  }
  CHECK(strain_between(at, all.readings.back()) == Approx(0.01).margin(2e-4));
  CHECK_THAT(rig.header().cut_short, Contains("by the intervention: switched"));
  const StageInfo& next = *rig.header().stage(2);
  CHECK(next.role == StageRole::shear);
  CHECK(next.control == AxialControl::displacement);
  CHECK(next.drainage == Drainage::closed);
}

TEST_CASE("masses and springs are handed over as a servo's load is") {
  const std::string crosshead = shear_stage("closed", "displacement", "axial_rate_mm_per_min = 0.5",
                                            R"("q_kPa", above = 30.0)");
  const std::string spring = shear_stage(
      "closed", "spring", "axial_rate_mm_per_min = 3.0\nspring_stiffness_N_per_mm = 20.0", kFar);
  const std::string masses = shear_stage("closed", "dead_load", "", R"("time_min", above = 60.0)");
  for (const auto& [stages, force] :
       {std::pair{spring, 160.0}, std::pair{crosshead + masses, 100.0}}) {
    VirtualRig rig(rig_programme(stages + kHandOver, kWithMass));
    const Guarded all = run_guarded(rig, force);
    REQUIRE(all.acted > 0);
    const Reading& at = all.readings[all.acted - 1];
    CHECK(rig.truth()->run_aways.empty());
    CHECK(strain_between(at, all.readings.back()) == Approx(0.01).margin(2e-4));
    CHECK(all.readings[all.acted][Quantity::axial_force] ==
          Approx(at[Quantity::axial_force]).margin(2));
  }
}

TEST_CASE("a load is not put on a specimen that was said to be lost in the stage before") {
  const std::string past_peak = shear_stage("closed", "displacement", "axial_rate_mm_per_min = 0.5",
                                            R"("axial_strain_pct", above = 0.7)");
  const std::string masses = shear_stage("closed", "dead_load", "impulse_N_s = 0.001", kFar);
  VirtualRig rig(rig_programme(past_peak + masses + kHandOver, kWithMass));
  Reading r, last;
  REQUIRE(rig.next(r));
  CHECK_FALSE(heed(rig, WarningLevel::lost));  // the crosshead holds it
  while (rig.next(r)) last = r;
  CHECK(rig.guarded());
  CHECK(last.stage == 3);
  CHECK(rig.truth()->run_aways.empty());

  VirtualRig taken_back(rig_programme(past_peak + masses + kHandOver, kWithMass));
  REQUIRE(taken_back.next(r));
  taken_back.heed(WarningLevel::imminent);
  taken_back.heed(WarningLevel::none);
  while (taken_back.next(r)) last = r;
  CHECK_FALSE(taken_back.guarded());
  CHECK(last.stage == 2);
  CHECK(taken_back.truth()->run_aways.size() == 1);
}

TEST_CASE("at held q the pressures stop with the hand-over, the valve stays as it was") {
  Programme programme = load_programme("samples/programmes/csu_41.toml");
  const auto stages = static_cast<int>(programme.stages.size());
  VirtualRig unguarded(programme);
  all_readings(unguarded);
  REQUIRE(unguarded.truth()->run_aways.size() == 1);
  const double fall_s = unguarded.truth()->run_aways[0].start_s;

  programme.guard = Guard{.rate_m_per_s = 0.5e-3 / 60, .further_strain = 0.01};
  VirtualRig rig(programme);
  Reading at, last;
  bool acted = false;
  for (Reading r; rig.next(r); last = r) {
    if (acted || r.time_s < fall_s - 30) continue;
    acted = heed(rig, WarningLevel::imminent).has_value();
    at = r;
  }
  REQUIRE(acted);
  CHECK(rig.truth()->run_aways.empty());
  CHECK(last.stage == stages + 1);  // shear by displacement before it has no successor
  CHECK(rig.header().stage(last.stage)->drainage == Drainage::closed);
  CHECK(last[Quantity::cell_pressure] == Approx(at[Quantity::cell_pressure]).margin(1e3));
  CHECK(last[Quantity::back_pressure] == Approx(at[Quantity::back_pressure]).margin(1e3));
  CHECK(last[Quantity::back_volume] == Approx(at[Quantity::back_volume]).margin(5e-9));
  CHECK(strain_between(at, last) == Approx(0.01).margin(2e-4));
}

TEST_CASE("in extension the crosshead goes on in extension, and takes back towards zero") {
  VirtualRig rig(rig_programme(by_load(-30) + kHandOver, kWithMass));
  const Guarded all = run_guarded(rig, 60);
  REQUIRE(all.acted > 0);
  CHECK(strain_between(all.readings[all.acted - 1], all.readings.back()) ==
        Approx(-0.01).margin(2e-4));
}

TEST_CASE("hold locks the crosshead for its time, and then the test ends") {
  VirtualRig rig(
      rig_programme(by_load(60) + guard("action = \"hold\"\nhold_min = 2.0\n"), kWithMass));
  const Guarded all = run_guarded(rig, 160);
  REQUIRE(all.acted > 0);
  const Reading &at = all.readings[all.acted - 1], &last = all.readings.back();
  CHECK(last.stage == 2);
  CHECK(rig.header().stage(2)->role == StageRole::hold);
  CHECK(last.time_s - at.time_s == Approx(120).margin(0.6));
  CHECK(std::fabs(strain_between(at, last)) < 1e-6);
  CHECK_THAT(rig.header().cut_short, Contains("crosshead locked"));
}

TEST_CASE("unload takes the share of q back and holds") {
  VirtualRig rig(rig_programme(
      by_load(60) +
          guard("action = \"unload\"\nrate_mm_per_min = 0.1\nshare = 0.25\nhold_min = 1\n"),
      kWithMass));
  const Guarded all = run_guarded(rig, 160);
  REQUIRE(all.acted > 0);
  const Reading &at = all.readings[all.acted - 1], &last = all.readings.back();
  CHECK(last[Quantity::axial_force] == Approx(0.75 * at[Quantity::axial_force]).epsilon(0.02));
  CHECK(strain_between(at, last) < 0);
  CHECK(rig.header().stage(2)->role == StageRole::hold);
  const auto held = of_stage(all.readings, 3);
  REQUIRE_FALSE(held.empty());
  CHECK(last.time_s - held.front().time_s == Approx(60).margin(1));
}

TEST_CASE("safe is the safe state") {
  VirtualRig rig(rig_programme(by_load(60) + guard("action = \"safe\"\n"), kWithMass));
  const Guarded all = run_guarded(rig, 160);
  REQUIRE(all.acted > 0);
  CHECK(all.readings.size() == all.acted + VirtualRig::kSafeReadings);
  CHECK_THAT(rig.header().cut_short, Contains("safe state") && Contains("by the intervention"));
  CHECK(rig.ending().kind == TestEnding::Kind::completed);
}

TEST_CASE("a guard acts at its level, once, and in the stages that it guards") {
  const std::string consolidation =
      stage_text("consolidation", "open", "free", "", R"("time_s", above = 1.0)");
  VirtualRig rig(rig_programme(consolidation + by_load(60) + kHandOver, kWithMass));
  Reading r;
  REQUIRE(rig.next(r));
  CHECK_FALSE(heed(rig, WarningLevel::lost));  // nothing is sheared yet
  rig.heed(WarningLevel::none);
  while (r.stage == 1) REQUIRE(rig.next(r));
  CHECK_FALSE(heed(rig, WarningLevel::approaching));
  CHECK(heed(rig, WarningLevel::lost));
  CHECK_FALSE(heed(rig, WarningLevel::lost));
  VirtualRig unguarded(rig_programme(by_load(60), kWithMass));
  REQUIRE(unguarded.next(r));
  CHECK_FALSE(heed(unguarded, WarningLevel::lost));
}

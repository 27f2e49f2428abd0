// SPDX-License-Identifier: GPL-3.0-or-later
// Loads that are put on and taken off at once, under the eyes of the supervision.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>

#include "lab/rig/session.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {

const std::string kOneMinute = "\"time_min\", above = 1.0";
const std::string kMassesAtRest = "[rig.frame]\nmoving_mass_kg = 5.0\ndamping_N_s_per_m = 500.0\n";

std::string step_text(const std::string& axial, double step_n, const std::string& keys = {}) {
  return test::shear_stage("open", axial, "load_step_N = " + std::to_string(step_n) + "\n" + keys,
                           kOneMinute);
}

struct Stepped {
  std::vector<Reading> readings;
  std::string warnings;

  Stepped(const std::string& stages, const std::string& rig = kMassesAtRest,
          const std::string& material = "sanisand/S28-general") {
    VirtualRig virtual_rig(test::rig_programme(stages, rig, 1, material));
    readings = test::all_readings(virtual_rig);
    for (const Warning& warning : virtual_rig.header().warnings) warnings += warning.text + "\n";
  }
  /// The force at the end of a stage, N.
  double force(int stage) const {
    const auto some = test::of_stage(readings, stage);
    return some.empty() ? kMissing : some.back()[Quantity::axial_force];
  }
};

}  // namespace

TEST_CASE("masses are put on and taken off, and supervision expects what they weigh") {
  const std::vector<double> steps = {5, 20, 120, -40, -80, 15};
  std::string stages;
  for (const double step : steps) stages += step_text("dead_load", step);
  const Stepped test(stages);
  CHECK(test.warnings.empty());
  CHECK(test.readings.back().time_s == 60.0 * double(steps.size()));
  double sum = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
    CHECK(test.force(int(i) + 1) == Approx(sum += steps[i]).margin(0.1));
}

TEST_CASE("a step of a servo is expected, too") {
  const double area = M_PI / 4 * 0.07 * 0.07;
  const Stepped test(step_text("load", 60, "load_rate_N_per_min = 5.0\n") +
                     step_text("load", -30, "load_rate_N_per_min = 5.0\n") +
                     step_text("constant_q", 25, "held_q_kPa = 10.0\n"));
  CHECK(test.warnings.empty());
  CHECK(test.force(1) == Approx(65).margin(0.5));
  CHECK(test.force(2) == Approx(40).margin(0.5));
  CHECK(test.force(3) == Approx(10e3 * area + 25).margin(0.5));
}

TEST_CASE("a mass that the load cell does not show is a load astray") {
  const std::string stuck = "[[faults]]\ndevice = \"axial_force\"\nkind = \"stuck\"\nfrom_s = ";
  const Stepped before(step_text("dead_load", 20) + step_text("dead_load", 30) + stuck + "50.0\n");
  CHECK_THAT(before.warnings,
             Contains("the load cell reads 20.0 N instead of the 50.0 N prescribed"));
  CHECK(before.readings.back().time_s < 90);
  // What it shows too much, likewise: 40 N within a minute.
  const Stepped drifting(step_text("dead_load", 20) + step_text("dead_load", 0) +
                         "[[faults]]\ndevice = \"axial_force\"\nkind = \"drift\"\nfrom_s = "
                         "61.0\ndrift_N_per_min = 40.0\n");
  CHECK_THAT(drifting.warnings, Contains("instead of the 20.0 N prescribed"));
}

TEST_CASE("INL2 under masses put on in steps carries its monotonic peak, its strain growing") {
  const std::string frame = "[rig.frame]\ntravel_mm = 24.0\n";
  for (const std::string law : {"inl2/S28-general", "octolinear/S28-general"}) {
    const Stepped plain(test::shear_stage("closed", "displacement", "axial_rate_mm_per_min = 0.2\n",
                                          "\"axial_strain_pct\", above = 1.0"),
                        frame, law);
    double peak = 0;
    for (const Reading& r : plain.readings) peak = std::max(peak, r[Quantity::axial_force]);

    // N; each rings by as much again. What rings by a third of the load takes something away.
    for (const auto& [step, within] : {std::pair(5.0, 0.03), std::pair(20.0, 0.06)}) {
      std::string stages;
      int count = 0;
      for (double load = 0; load < 1.1 * peak; ++count) {
        const double next = load < 120 ? step : 2;
        load += next;
        stages +=
            test::shear_stage("closed", "dead_load", "load_step_N = " + std::to_string(next) + "\n",
                              "\"time_min\", above = 0.1");
      }
      const Stepped stepped(stages, frame, law);
      double carried = 0, before = -1;
      for (int stage = 1; stage <= count; ++stage) {
        const auto some = test::of_stage(stepped.readings, stage);
        if (some.empty()) break;
        const double strained = some.back()[Quantity::axial_displacement];
        INFO(law << ", steps of " << step << " N, step " << stage);
        CHECK(strained > before - 5e-6);  // m
        before = strained;
        carried = std::max(carried, stepped.force(stage));
      }
      INFO(law << ", steps of " << step << " N");
      CHECK(carried < 1.03 * peak);
      CHECK(carried + 2 > (1 - within) * peak);  // the next step was 2 N
    }
  }
}

TEST_CASE("steps of dead load, undrained: each settles until one does not, and that is the onset") {
  const auto [count, step_n] = GENERATE(
      table<int, double>({std::tuple(60, 5.0), std::tuple(16, 20.0), std::tuple(8, 50.0)}));
  std::string stages;
  for (int i = 0; i < count; ++i)
    stages += test::shear_stage("closed", "dead_load", "load_step_N = " + std::to_string(step_n),
                                kOneMinute);
  INFO("steps of " << step_n << " N");
  // Where masses swing the law stiffens: a wobble is a reversal to it.
  const std::string damped = "[rig.frame]\nmoving_mass_kg = 5.0\ndamping_N_s_per_m = 5000.0\n";
  VirtualRig rig(test::rig_programme(stages, damped, 1, "sanisand/S28-general"));
  const TestSummary seen = run_session(rig, {});
  const Truth& truth = *seen.truth;
  REQUIRE(truth.lost_sustainability);
  CHECK(truth.run_aways.back().end == RunAwayEnd::end_of_travel);
  CHECK(*truth.time_s == Approx(truth.run_aways.back().start_s).margin(1));
  REQUIRE(seen.collapse.kind == CollapseKind::flow);
  CHECK(*seen.collapse.onset->time_s == Approx(*truth.time_s).margin(1));
  // The step that was too large goes past the state at which second-order work vanishes.
  CHECK(*seen.collapse.onset->axial_strain <= *truth.axial_strain + 0.005);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/axis_control.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/rig_header.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;

namespace {

constexpr double kArea = 0.07 * 0.07 * 3.14159265358979323846 / 4;

Seen seen_with(double force_n, double pore_pa = 300e3) {
  Seen seen(rig_header(read_programme(test::programme_text(), "p.toml"), 1));
  Reading r;
  r.time_s = 0;
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) r.si[i] = 0;
  r[Quantity::axial_force] = force_n;
  r[Quantity::cell_pressure] = 400e3;
  r[Quantity::pore_pressure] = pore_pa;
  seen.take(r);
  seen.begin_stage();
  return seen;
}

AxisControl axis_started(const Stage& stage, const Seen& seen, double true_force_n) {
  AxisControl axis;
  axis.begin_stage(stage, seen, true_force_n);
  return axis;
}

}  // namespace

TEST_CASE("a load starts from what stands on the piston and rises at its rate") {
  Stage stage;
  stage.axial = AxialAction::load;
  stage.load_rate_n_per_s = 2;
  Seen seen = seen_with(100);
  AxisControl axis = axis_started(stage, seen, 100);
  CHECK(axis.demand(seen, 400e3, 0.5).force_n == Approx(101).epsilon(1e-12));
  seen.add_stage_time(0.5);
  CHECK(axis.demand(seen, 400e3, 0.5).start_force_n > 100.9);
}

TEST_CASE("a servo believes its load cell: an offset makes a wrong force, without a jump") {
  Stage stage;
  stage.axial = AxialAction::load;
  Seen seen = seen_with(100);
  AxisControl axis = axis_started(stage, seen, 90);  // reads 10 N too much
  CHECK(axis.demand(seen, 400e3, 1).force_n == Approx(90));
  const Seen less = seen_with(95);
  axis.demand(less, 400e3, 1);
  CHECK(axis.demand(less, 400e3, 1).force_n ==
        Approx(90 + 2 * 5 * AxisControl::kTrim_per_s).epsilon(1e-9));
  CHECK(axis.wanted_force_n() == 100.0);
}

TEST_CASE(
    "a held q asks for q times the area, a stress ratio for its q at the next cell pressure") {
  Stage stage;
  stage.axial = AxialAction::constant_q;
  stage.held_q_pa = 50e3;
  const Seen seen = seen_with(0);
  CHECK(axis_started(stage, seen, 0).demand(seen, 400e3, 1).force_n == Approx(50e3 * kArea));
  stage.axial = AxialAction::stress_ratio;
  stage.held_stress_ratio = 0.5;
  const double q = axis_started(stage, seen, 0).demand(seen, 420e3, 1).force_n / kArea;
  CHECK(q / (120e3 + q / 3) == Approx(0.5));
}

TEST_CASE("a dead load keeps the true force, and a perturbation comes once") {
  Stage stage;
  stage.axial = AxialAction::dead_load;
  stage.load_step_n = 3;
  stage.impulse_n_s = 0.1;
  const Seen seen = seen_with(100);
  AxisControl axis = axis_started(stage, seen, 97);
  const AxisDemand first = axis.demand(seen, 400e3, 1);
  CHECK(first.dead);
  CHECK(first.force_n == 100);
  CHECK(first.perturbed);
  CHECK(first.impulse_n_s == 0.1);
  const AxisDemand second = axis.demand(seen, 400e3, 1);
  CHECK(second.force_n == 100);
  CHECK_FALSE(second.perturbed);
  CHECK(second.impulse_n_s == 0);
  CHECK_FALSE(axis.wanted_force_n() == 97.0);
}

TEST_CASE("crosshead and free piston ask for no force") {
  Stage stage;
  stage.axial = AxialAction::spring;
  stage.axial_rate_m_per_s = 1e-6;
  stage.spring_stiffness_n_per_m = 5e4;
  const Seen seen = seen_with(100);
  const AxisDemand spring = axis_started(stage, seen, 100).demand(seen, 400e3, 1);
  CHECK(spring.kind == AxisDemand::Kind::crosshead);
  CHECK(spring.velocity_m_per_s == 1e-6);
  CHECK(spring.spring_n_per_m == 5e4);
  stage.axial = AxialAction::free;
  CHECK(axis_started(stage, seen, 100).demand(seen, 400e3, 1).kind == AxisDemand::Kind::free);
}

TEST_CASE("a filter takes the noise out of the area, and follows a steady change without lag") {
  Stage stage;
  stage.axial = AxialAction::constant_q;
  stage.held_q_pa = 50e3;
  // Shortening at 1 µm a tick (area grows), with a wobble of 1 µm on it.
  const auto last_steps = [&stage](double filter_s, double wobble_m) {
    Seen seen = seen_with(0);
    AxisControl axis(AxisControl::Servo{.ideal = false, .filter_s = filter_s});
    axis.begin_stage(stage, seen, 0);
    double before = 0, largest = 0;
    for (int i = 1; i <= 2000; ++i) {
      Reading r;
      r.time_s = 0.25 * i;
      for (std::size_t k = 0; k < kRawQuantityCount; ++k) r.si[k] = 0;
      r[Quantity::cell_pressure] = 400e3;
      r[Quantity::pore_pressure] = 300e3;
      r[Quantity::axial_force] = before;  // the cylinder does what it is asked
      r[Quantity::axial_displacement] = 1e-6 * i + (i % 2 == 0 ? wobble_m : -wobble_m);
      seen.take(r);
      const double force = axis.demand(seen, 400e3, 0.25).force_n;
      if (i > 1900) largest = std::max(largest, std::fabs(force - before));
      before = force;
    }
    const double exact = 50e3 * kArea / (1 - 1e-6 * 2001 / 0.14);
    return std::pair{largest, before / exact - 1};
  };
  const auto [still, off] = last_steps(10, 0);
  const auto [filtered, unused] = last_steps(10, 1e-6);
  const auto [bare, unused_too] = last_steps(0, 1e-6);
  CHECK(std::fabs(off) < 1e-6);
  CHECK(filtered < 1.3 * still);
  CHECK(bare > 4 * still);
}

TEST_CASE("at constant q a spike of the displacement or the volume moves no force") {
  for (const auto& [channel, size] :
       {std::pair(Quantity::axial_displacement, 1e-3), std::pair(Quantity::back_volume, 2e-6)}) {
    Stage stage;
    stage.axial = AxialAction::constant_q;
    stage.held_q_pa = 100e3;
    Seen seen = seen_with(100e3 * kArea);
    AxisControl axis = axis_started(stage, seen, 100e3 * kArea);
    double largest = 0;
    for (int look = 1; look < 20; ++look) {
      Reading r;
      r.time_s = 0.25 * look;
      for (std::size_t i = 0; i < kRawQuantityCount; ++i) r.si[i] = 0;
      r[Quantity::axial_force] = 100e3 * kArea;
      r[Quantity::cell_pressure] = 400e3;
      r[Quantity::pore_pressure] = 300e3;
      if (look == 7 || look == 12) r[channel] = look == 7 ? size : -size;
      seen.take(r);
      const double force = axis.demand(seen, 400e3, 0.25).force_n;
      largest = std::max(largest, std::fabs(force - 100e3 * kArea));
    }
    INFO(info(channel).name);
    CHECK(largest < 0.01);  // N; followed, a spike makes up to 5 N
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/pressure_controller.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/devices/noise.hpp"

using namespace triax::lab;

TEST_CASE("a controller ramps to its target, exactly, and not beyond its limits") {
  const PressureController c{.range_pa = 1e6, .rate_limit_pa_per_s = 500};
  CHECK(process(c, 100e3, {}, 10) == 100e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = 100, .target_pa = {}}, 10) == 101e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = -100, .target_pa = {}}, 10) == 99e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = 100, .target_pa = 100.5e3}, 10) == 100.5e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = -100, .target_pa = 99.5e3}, 10) == 99.5e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = 9e3, .target_pa = {}}, 10) == 105e3);
  CHECK(process(c, 999e3, {.rate_pa_per_s = 500, .target_pa = {}}, 10) == 1e6);
  CHECK(process(c, 1e3, {.rate_pa_per_s = -500, .target_pa = {}}, 10) == 0);
  // Already beyond the target: the ramp does not turn round.
  CHECK(process(c, 100e3, {.rate_pa_per_s = 100, .target_pa = 90e3}, 10) == 100e3);
}

namespace {

constexpr double kMm3 = 1e-9;

PressureController ideal() { return {.range_pa = 1e6, .rate_limit_pa_per_s = 1e4}; }

/// 100 kPa held for `seconds` in ticks, with an inflow.
ControllerState held(const PressureController& c, double seconds, double inflow_m3_per_s,
                     double tick_s = 0.25, const std::vector<Fault>& active = {}) {
  ControllerState state = at_rest(c, 100e3);
  const int ticks = static_cast<int>(std::lround(seconds / tick_s));
  for (int i = 0; i < ticks; ++i) advance(c, state, {}, inflow_m3_per_s * tick_s, tick_s, active);
  return state;
}

std::vector<Fault> one(FaultKind kind, double size = 0) {
  return {{.device = "back_controller", .kind = kind, .size = size}};
}

/// What came in is what the piston made room for and what the compliance took, less the leak.
double stored_m3(const PressureController& c, const ControllerState& state) {
  return c.fluid_compliance_m3_per_pa * (state.pressure_pa - 100e3);
}

}  // namespace

TEST_CASE("an ideal controller ramps as asked, to the bit, and gives what flows out of it") {
  const PressureController c = ideal();
  ControllerState state = at_rest(c, 100e3);
  const PressureDemand demand{.rate_pa_per_s = 333.3, .target_pa = 101e3};
  double expected = 100e3;
  for (int i = 0; i < 20; ++i) {
    expected = process(c, expected, demand, 0.25);
    advance(c, state, demand, -2 * kMm3, 0.25);
    CHECK(state.pressure_pa == expected);
  }
  CHECK(state.pressure_pa == 101e3);
  CHECK(state.given_volume_m3 == Approx(40 * kMm3));
  CHECK(state.held_volume_m3 == Approx(-40 * kMm3));
  CHECK_FALSE(state.full);
  CHECK_FALSE(state.empty);
}

TEST_CASE("set points are whole steps of the resolution") {
  PressureController c = ideal();
  c.pressure_resolution_pa = 1e3;
  ControllerState state = at_rest(c, 100e3);
  for (int i = 1; i <= 40; ++i) {
    advance(c, state, {.rate_pa_per_s = 100, .target_pa = {}}, 0, 1);
    CHECK(state.pressure_pa == 1e3 * std::round((100e3 + 100 * i) / 1e3));
    CHECK(state.asked_pa == Approx(100e3 + 100 * i));
  }
}

TEST_CASE("the loop answers a step with its time constant") {
  PressureController c = ideal();
  c.time_constant_s = 4;
  c.rate_limit_pa_per_s = 1e9;
  ControllerState state = at_rest(c, 100e3);
  state.asked_pa = 200e3;
  for (int i = 0; i < 12; ++i) advance(c, state, {}, 0, 0.5);
  CHECK(state.pressure_pa == Approx(200e3 - 100e3 * std::exp(-1.5)).epsilon(1e-13));
}

TEST_CASE("a constant inflow lifts the pressure by flow x time constant / compliance") {
  PressureController c = ideal();
  c.time_constant_s = 2;
  c.fluid_compliance_m3_per_pa = 5 * kMm3 / 1e3;
  const ControllerState state = held(c, 100, 3 * kMm3);
  CHECK(state.pressure_pa - 100e3 == Approx(3.0 * 2 / 5 * 1e3).epsilon(1e-9));
  CHECK(-state.given_volume_m3 + stored_m3(c, state) == Approx(300 * kMm3).epsilon(1e-12));
  // The course too, and whatever the tick.
  const double way = 1 - std::exp(-0.5);
  CHECK(held(c, 1, 3 * kMm3, 0.25).pressure_pa == Approx(100e3 + 1.2e3 * way).epsilon(1e-12));
  CHECK(held(c, 1, 3 * kMm3, 0.01).pressure_pa == Approx(100e3 + 1.2e3 * way).epsilon(1e-12));
}

TEST_CASE("without a compliance no flow disturbs the loop") {
  PressureController c = ideal();
  c.time_constant_s = 2;
  CHECK(held(c, 100, 3 * kMm3).pressure_pa == 100e3);
}

TEST_CASE("the piston is no faster than its limit: the rest goes into the compliance") {
  PressureController c = ideal();
  c.fluid_compliance_m3_per_pa = 5 * kMm3 / 1e3;
  c.volume_rate_limit_m3_per_s = 2 * kMm3;
  const ControllerState state = held(c, 100, 3 * kMm3);
  CHECK(state.given_volume_m3 == Approx(-200 * kMm3));
  CHECK(state.pressure_pa == Approx(100e3 + 100.0 / 5 * 1e3).epsilon(1e-12));
  CHECK(held(c, 100, 1.9 * kMm3).pressure_pa == Approx(100e3));
}

TEST_CASE("a leak is held against, shows in the volume and empties the cylinder in V/(L p)") {
  PressureController c = ideal();
  c.capacity_m3 = 1000 * kMm3;
  c.fluid_compliance_m3_per_pa = 2 * kMm3 / 1e3;
  c.leak_m3_per_s_per_pa = 0.5 * kMm3 / 100e3;
  ControllerState state = held(c, 100, 0);
  CHECK(state.pressure_pa == 100e3);
  CHECK(state.given_volume_m3 == Approx(50 * kMm3));
  state = held(c, 999.75, 0);
  CHECK_FALSE(state.empty);
  state = held(c, 1000.25, 0);
  CHECK(state.empty);
  CHECK_FALSE(state.full);
  // Then what is left leaks out of the compliance: p = p_0 exp(-L t/C).
  state = held(c, 1400, 0);
  CHECK(state.pressure_pa == Approx(100e3 * std::exp(-400 * 0.5e-5 / 2e-3)).epsilon(1e-9));
  CHECK(state.given_volume_m3 == Approx(500 * kMm3).epsilon(1e-12));
}

TEST_CASE("a leak in front of a loop costs pressure: set / (1 + L tau / C)") {
  PressureController c = ideal();
  c.time_constant_s = 3;
  c.fluid_compliance_m3_per_pa = 2 * kMm3 / 1e3;
  c.leak_m3_per_s_per_pa = 0.4 * kMm3 / 100e3;
  const ControllerState state = held(c, 300, 0);
  CHECK(state.pressure_pa == Approx(100e3 / (1 + 0.4e-5 * 3 / 2e-3)).epsilon(1e-12));
  // Water is not lost in the book: given = stored + leaked; the leak from the pressure's course.
  const double rest = state.pressure_pa, rate = 1.0 / 3 + 0.4e-5 / 2e-3;
  const double leaked = c.leak_m3_per_s_per_pa * (rest * 300 + (100e3 - rest) / rate);
  CHECK(state.given_volume_m3 == Approx(stored_m3(c, state) + leaked).epsilon(1e-10));
}

TEST_CASE("a full cylinder takes no more: the pressure rises with what flows in") {
  PressureController c = ideal();
  c.capacity_m3 = 100 * kMm3;
  c.start_volume_m3 = 70 * kMm3;
  c.fluid_compliance_m3_per_pa = 5 * kMm3 / 1e3;
  const ControllerState state = held(c, 50, kMm3);
  CHECK(state.full);
  CHECK(state.held_volume_m3 == Approx(100 * kMm3));
  CHECK(state.pressure_pa == Approx(100e3 + 20.0 / 5 * 1e3));
  c.fluid_compliance_m3_per_pa = 0;
  CHECK(held(c, 50, kMm3).pressure_pa == 100e3);
  CHECK(held(c, 50, kMm3).full);
  CHECK_FALSE(held(c, 29, kMm3).full);
  CHECK(held(c, 71, -kMm3).empty);
}

TEST_CASE("a stuck piston gives no readings: the ramp does not come, inflow raises the pressure") {
  PressureController c = ideal();
  c.fluid_compliance_m3_per_pa = 5 * kMm3 / 1e3;
  ControllerState state = at_rest(c, 100e3);
  const auto active = one(FaultKind::stuck);
  for (int i = 0; i < 10; ++i)
    advance(c, state, {.rate_pa_per_s = 1e3, .target_pa = {}}, kMm3, 1, active);
  CHECK(state.pressure_pa == Approx(102e3));
  CHECK(state.given_volume_m3 == 0);
  CHECK(state.asked_pa == 110e3);
  c.fluid_compliance_m3_per_pa = 0;
  state = at_rest(c, 100e3);
  advance(c, state, {.rate_pa_per_s = 1e3, .target_pa = {}}, 0, 1, active);
  CHECK(state.pressure_pa == 100e3);
}

TEST_CASE("the faults full, empty and leak act as if they were so") {
  PressureController c = ideal();
  c.fluid_compliance_m3_per_pa = 5 * kMm3 / 1e3;
  const ControllerState full = held(c, 10, kMm3, 0.25, one(FaultKind::full));
  CHECK(full.full);
  CHECK(full.pressure_pa == Approx(102e3));
  CHECK(held(c, 10, -kMm3, 0.25, one(FaultKind::full)).pressure_pa == Approx(100e3));
  const ControllerState empty = held(c, 10, -kMm3, 0.25, one(FaultKind::empty));
  CHECK(empty.empty);
  CHECK(empty.pressure_pa == Approx(98e3));
  const double leak = 0.5 * kMm3 / 100e3;
  CHECK(held(c, 10, 0, 0.25, one(FaultKind::leak, leak)).given_volume_m3 == Approx(5 * kMm3));
}

TEST_CASE("pressures stay between 0 and the range whatever flows") {
  PressureController c = ideal();
  c.fluid_compliance_m3_per_pa = kMm3 / 1e3;
  CHECK(held(c, 1000, 10 * kMm3, 0.25, one(FaultKind::stuck)).pressure_pa == 1e6);
  CHECK(held(c, 1000, -10 * kMm3, 0.25, one(FaultKind::stuck)).pressure_pa == 0);
}

TEST_CASE("under volume control the piston pushes the flow, its own water's share and the leak") {
  PressureController c = ideal();
  c.fluid_compliance_m3_per_pa = 5 * kMm3 / 1e3;
  c.capacity_m3 = 200e-6;
  ControllerState state = at_rest(c, 100e3);
  double flow = 2 * kMm3;
  push(c, state, flow, 104e3, 10);
  CHECK(flow == 2 * kMm3);
  CHECK(state.pressure_pa == 104e3);
  CHECK(state.asked_pa == 104e3);
  CHECK(state.given_volume_m3 == Approx((20 + 20) * kMm3));
  CHECK(state.held_volume_m3 == Approx(100e-6 - 40 * kMm3));
  c.leak_m3_per_s_per_pa = 0.1 * kMm3 / 100e3;
  push(c, state, flow, 104e3, 10);
  CHECK(state.given_volume_m3 == Approx((40 + 20 + 1.04) * kMm3));
  // Pressure control goes on from there.
  advance(c, state, {}, 0, 1);
  CHECK(state.pressure_pa == 104e3);
}

TEST_CASE("a flow that the piston cannot give is cut, and said") {
  PressureController c = ideal();
  c.fluid_compliance_m3_per_pa = 5 * kMm3 / 1e3;
  c.volume_rate_limit_m3_per_s = 3 * kMm3;
  c.capacity_m3 = 100 * kMm3;
  ControllerState state = at_rest(c, 100e3);
  CHECK(possible_flow(c, state, 2 * kMm3, 1) == 2 * kMm3);
  CHECK(possible_flow(c, state, -4 * kMm3, 1) == Approx(-3 * kMm3));
  CHECK(possible_flow(c, state, 4 * kMm3, 1, one(FaultKind::stuck)) == 0);
  CHECK(possible_flow(c, state, 4 * kMm3, 100) == Approx(0.5 * kMm3));
  double flow = 2 * kMm3;
  for (int i = 0; i < 40; ++i) push(c, state, flow, 100e3, 1);
  CHECK(state.empty);
  CHECK(flow == 0);
  CHECK(state.given_volume_m3 == Approx(50 * kMm3));
}

TEST_CASE("water is not lost and pressures are numbers, whatever the controller and its faults") {
  std::uint64_t drawn = 0;
  const auto any = [&](double low, double high) {
    return low + (high - low) * standard_uniform(11, 5, ++drawn);
  };
  const auto some = [&](double high) { return any(0, 1) < 0.3 ? 0 : any(0, high); };
  const std::vector<FaultKind> kinds{FaultKind::stuck, FaultKind::full, FaultKind::empty};
  int inside = 0;
  for (int run = 0; run < 500; ++run) {
    PressureController c = ideal();
    c.pressure_resolution_pa = some(2e3);
    c.time_constant_s = some(5);
    c.fluid_compliance_m3_per_pa = any(0.5, 10) * kMm3 / 1e3;
    c.capacity_m3 = some(500 * kMm3);
    c.volume_rate_limit_m3_per_s = some(20 * kMm3);
    std::vector<Fault> active;
    for (const FaultKind kind : kinds)
      if (any(0, 1) < 0.2) active.push_back(one(kind).front());
    ControllerState state = at_rest(c, 500e3);
    const PressureDemand demand{.rate_pa_per_s = any(-3e3, 3e3), .target_pa = {}};
    double inflow = 0;
    bool limited = false;
    for (int i = 0; i < 100; ++i) {
      const double in = any(-5, 5) * kMm3;
      inflow += in;
      advance(c, state, demand, in, 0.25, active);
      REQUIRE(std::isfinite(state.pressure_pa));
      REQUIRE((state.pressure_pa >= 0 && state.pressure_pa <= c.range_pa));
      if (c.capacity_m3 > 0)
        REQUIRE((state.held_volume_m3 > -1e-15 && state.held_volume_m3 < c.capacity_m3 + 1e-15));
      limited = limited || state.pressure_pa == 0 || state.pressure_pa == c.range_pa;
    }
    if (limited) continue;
    ++inside;
    const double stored = c.fluid_compliance_m3_per_pa * (state.pressure_pa - 500e3);
    CHECK(inflow + state.given_volume_m3 - stored == Approx(0).margin(1e-9 * kMm3 * 1e3));
  }
  CHECK(inside > 300);
}

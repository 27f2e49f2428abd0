// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/cycles.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "lab/collapse/monitor.hpp"

using namespace triax::lab;

namespace {

constexpr double kP0 = 100e3;

/// 80 readings a cycle; r_u and double amplitude as they are given for each cycle.
struct Cyclic {
  double mean = 0, amplitude = 20e3;
  double pore_ratio_a_cycle = 0.1, strain_a_cycle = 0;

  State state(int i) const {
    const double cycle = i / 80.0;
    const double wave = std::sin(2 * std::numbers::pi * cycle);
    State s;
    s.reading = i;
    s.time_s = i;
    s.q = mean + amplitude * wave;
    s.pore_pressure = 300e3 + std::min(1.0, pore_ratio_a_cycle * cycle) * kP0;
    s.p_eff = kP0 - (s.pore_pressure - 300e3) + s.q / 3;
    s.strain.axial = 0.5 * strain_a_cycle * cycle * wave;
    s.strain.radial = -s.strain.axial / 2;
    s.volumetric_strain = 0;
    s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
    return s;
  }
};

std::optional<CyclicLoading> loading(const Cyclic& test, int readings) {
  CycleCounter counter(true);
  for (int i = 0; i < readings; ++i) counter.add(test.state(i));
  return counter.loading();
}

}  // namespace

TEST_CASE("cycles, their stress ratio and their least and largest q") {
  const auto found = loading({.mean = 10e3, .pore_ratio_a_cycle = 0}, 80 * 6 + 1);
  REQUIRE(found);
  CHECK(found->cycles == Approx(6));
  CHECK(found->q_high_pa == Approx(30e3));
  CHECK(found->q_low_pa == Approx(-10e3));
  // amplitude of q over 2 p′₀, of which q at the start is a part
  CHECK(found->stress_ratio == Approx(20e3 / 2 / (kP0 + 10e3 / 3)));
  CHECK_FALSE(found->liquefied);
  CHECK_FALSE(found->double_amplitude);
}

TEST_CASE("r_u of 0.95 and a double amplitude of 5 %, with their cycles") {
  const auto found = loading({.pore_ratio_a_cycle = 0.1, .strain_a_cycle = 0.011}, 80 * 12);
  REQUIRE(found);
  REQUIRE(found->liquefied);
  CHECK(found->liquefied->instant.reading == 760);  // 9.5 cycles
  CHECK(found->liquefied->cycle == 10);
  CHECK(found->largest_pore_pressure_ratio == Approx(1.0));
  // 0.55 % a cycle more to each side: 4.95 % from the fifth peak to its trough, 5.5 % on to the
  // sixth.
  REQUIRE(found->double_amplitude);
  CHECK(found->double_amplitude->cycle == 6);
}

TEST_CASE("the cycle of an event is the logger's own, counted from 0, from 1 or in fractions") {
  // The logger counts two cycles where q turns once up and once down.
  const auto cycle = [](double from, double each_reading, bool whole) {
    CycleCounter counter(true);
    for (int i = 0; i < 1000; ++i) {
      State state = Cyclic{}.state(i);
      const double counted = each_reading * i + 1e-9;
      state.cycle = from + (whole ? std::floor(counted) : counted);
      counter.add(state);
    }
    return counter.loading()->liquefied->cycle;
  };
  const int by_q = loading({}, 1000)->liquefied->cycle;
  CHECK(by_q == 10);
  CHECK(cycle(0, 1.0 / 40, false) == 20);
  CHECK(cycle(0, 1.0 / 40, true) == 20);
  CHECK(cycle(1, 1.0 / 40, true) == 20);
}

TEST_CASE("cycles about a static shear that the record begins with are counted") {
  CycleCounter counter(true);
  State s = Cyclic{}.state(0);
  for (int i = 0; i < 80 * 12; ++i) {
    s.reading = i;
    s.q = std::min(100e3, 500.0 * i);
    if (i > 200) s.q += 15e3 * std::sin(2 * std::numbers::pi * (i - 200) / 80.0);
    counter.add(s);
  }
  REQUIRE(counter.loading());
  CHECK(counter.loading()->q_high_pa == Approx(115e3).epsilon(0.01));
  CHECK(counter.loading()->q_low_pa == Approx(85e3).epsilon(0.01));
}

TEST_CASE("shear between and after loops of unloading is no double amplitude") {
  CycleCounter counter(true);
  State s = Cyclic{}.state(0);
  const auto go_to = [&](double q, double strain) {
    const double q0 = s.q, strain0 = s.strain.axial;
    for (int i = 1; i <= 100; ++i) {
      ++s.reading;
      s.q = std::lerp(q0, q, i / 100.0);
      s.strain.axial = std::lerp(strain0, strain, i / 100.0);
      counter.add(s);
    }
  };
  go_to(60e3, 0.005);
  go_to(10e3, 0.0045);
  go_to(60e3, 0.005);
  go_to(90e3, 0.07);
  go_to(20e3, 0.0695);
  go_to(90e3, 0.07);
  go_to(120e3, 0.14);
  REQUIRE(counter.loading());
  CHECK(counter.loading()->cycles == 2);
  CHECK(counter.loading()->largest_double_amplitude < 0.03);
  CHECK_FALSE(counter.loading()->double_amplitude);
}

TEST_CASE("a monotonic test with noise is no cyclic test") {
  std::mt19937_64 rng(5);
  std::normal_distribution<double> noise(0, 100);
  CycleCounter counter(true);
  State s = Cyclic{}.state(0);
  for (int i = 0; i < 3000; ++i) {
    s.reading = i;
    s.q = 50e3 * (1 - std::exp(-i / 500.0)) + noise(rng);
    counter.add(s);
  }
  CHECK_FALSE(counter.loading());
}

TEST_CASE("carried on: q comes back after it fell, not at the turn from which it fell") {
  const Cyclic test{.pore_ratio_a_cycle = 0.1};
  const int after_peak = 80 * 5 + 22, loss = 80 * 5 + 18;  // it peaks at 420
  CycleCounter falls(true), goes_on(true);
  for (int i = 0; i <= after_peak + 400; ++i) {
    State s = test.state(i);
    goes_on.add(s);
    if (i > after_peak) s.q = 1e3;
    falls.add(s);
  }
  CHECK_FALSE(falls.carried_on(loss, 20e3));
  CHECK(goes_on.carried_on(loss, 20e3));
  CHECK_FALSE(goes_on.carried_on(loss, 30e3));
  // What was lost in extension is not carried by peaks of compression.
  CycleCounter lopsided(true);
  for (int i = 0; i < 80 * 8; ++i) lopsided.add(Cyclic{.mean = 20e3, .amplitude = 40e3}.state(i));
  CHECK(lopsided.carried_on(200, -20e3));
  CHECK_FALSE(lopsided.carried_on(200, -50e3));
}

TEST_CASE("cyclic mobility: r_u near one while the load is carried on is a kind of its own") {
  RecordHeader header;
  header.stages = {{.number = 1,
                    .name = "cycles",
                    .role = StageRole::shear,
                    .drainage = Drainage::closed,
                    .control = AxialControl::load}};
  const Cyclic test{.pore_ratio_a_cycle = 0.1, .strain_a_cycle = 0.01};
  CollapseMonitor monitor(header);
  for (int i = 0; i < 80 * 12; ++i) {
    State s = test.state(i);
    s.stage = 1;
    monitor.watch(s);
  }
  const Collapse c = monitor.finish();
  CHECK(c.judged);
  CHECK(c.kind == CollapseKind::cyclic_mobility);
  REQUIRE(c.onset);
  CHECK(monitor.cyclic()->cycles == Approx(12).margin(0.6));
}

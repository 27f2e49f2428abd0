// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/cyclic_warning.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "lab/warning/warning_limits.hpp"

using namespace triax::lab;

namespace {

constexpr double kPi = 3.14159265358979;

/// q = q_a sin 2πN, p′ = p₀ left(N), ε = k s − h cos 2πN/left², s the sine of the mobilised
/// friction angle: the work of a cycle is about π q_a h/left².
struct CyclicPath {
  double p0_pa = 1e5, q_a_pa = 2e4, q_m_pa = 0;
  double strain_per_s = 2e-3, loop = 1e-4;
  std::function<double(double)> left = [](double) { return 1.0; };
  int readings_per_cycle = 80;
  double cycles = 0;  ///< applied so far
  int reading = 0;

  State next() {
    State s;
    s.reading = reading;
    s.time_s = reading++;
    s.q = q_m_pa + q_a_pa * std::sin(2 * kPi * cycles);
    s.p_eff = p0_pa * left(cycles);
    const double sine = 3 * s.eta() / (6 + s.eta());
    const double axial =
        strain_per_s * sine - loop * std::cos(2 * kPi * cycles) / std::pow(left(cycles), 2);
    s.strain = {axial, -axial / 2};
    s.volumetric_strain = 0;
    cycles += 1.0 / readings_per_cycle;
    return s;
  }
};

/// Flow failure: p′ falls faster and faster, to zero at N = 10.
double flows(double cycles) { return std::sqrt(std::max(0.0, 1 - cycles / 10)); }
/// Shakedown: p′ falls less and less, to 0.6 p₀.
double shakes_down(double cycles) { return 0.6 + 0.4 * std::exp(-cycles / 3); }

/// Cycles at which the warning was issued for the first time; NaN: never.
double apply(CyclicWarning& warning, CyclicPath& path, double until) {
  double issued = kMissing;
  while (path.cycles < until) {
    const double now = path.cycles;
    if (warning.add(path.next()) && warning.is_imminent() && std::isnan(issued)) issued = now;
  }
  return issued;
}

}  // namespace

TEST_CASE("CyclicWarning: issues a warning before a flow failure", "[warning][cyclic]") {
  for (const int readings : {20, 80, 300}) {
    CyclicWarning warning(true);
    CyclicPath path{.left = flows, .readings_per_cycle = readings};
    const double issued = apply(warning, path, 9.4);
    INFO(readings << " readings per cycle, issued at " << issued);
    CHECK(issued > 6.5);
    CHECK(issued < 9);
    CHECK(warning.is_imminent());
    CHECK(warning.probability() > 0.9);
    CHECK(warning.cycles() == Approx(9.0).margin(0.5));
    CHECK(warning.restart() == CyclicWarning::Restart::none);
  }
}

TEST_CASE("CyclicWarning: noise of a held load is no cycle", "[warning][cyclic]") {
  CyclicWarning warning(true);
  CyclicPath path{.q_a_pa = 0, .q_m_pa = 3e4};
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 1.5e3);
  for (int i = 0; i < 500; ++i) {
    State state = path.next();
    state.q += noise(random);
    warning.add(state);
  }
  CHECK_FALSE(warning.is_cyclic());
  CHECK(warning.cycles() < 1);
}

TEST_CASE("CyclicWarning: issues none while a specimen shakes down", "[warning][cyclic]") {
  for (const double middle : {0.0, 3e4}) {
    CyclicWarning warning(true);
    CyclicPath path{.q_m_pa = middle, .left = shakes_down};
    CHECK(std::isnan(apply(warning, path, 30)));
    CHECK(warning.probability() < 0.01);
    CHECK(warning.cycles() == Approx(30).margin(0.5));
  }
}

TEST_CASE("CyclicWarning: compares the first cycle with a virtual one", "[warning][cyclic]") {
  CyclicWarning warning(true);
  CyclicPath path{.left = [](double) { return 0.8; }};
  State first = path.next();
  first.p_eff = path.p0_pa;
  first.cycle = 0;  // the record counts cycles, so that two turns are enough
  warning.add(first);
  apply(warning, path, 0.95);
  REQUIRE(warning.numbers());
  const auto sine = [](double eta) { return 3 * eta / (6 + eta); };
  // Largest in extension, at q = −20 kPa.
  CHECK((*warning.numbers())[0] == Approx(std::log(sine(-0.2) - sine(-0.25))).margin(0.02));
  CHECK((*warning.numbers())[1] == 0.2);
  CHECK((*warning.numbers())[3] == 0.2);
}

TEST_CASE("CyclicWarning: measures growth, work and shift of a cycle", "[warning][cyclic]") {
  CyclicWarning warning(true);
  CyclicPath path{.strain_per_s = 0, .left = [](double n) { return n < 3 ? 1.0 : 0.9; }};
  apply(warning, path, 3.9);
  REQUIRE(warning.numbers());
  const auto& x = *warning.numbers();
  const auto sine = [](double eta) { return 3 * eta / (6 + eta); };
  CHECK(x[0] == Approx(std::log(sine(-0.2) - sine(-0.2 / 0.9))).margin(0.02));
  const double work = -2 * std::log(0.9);  // of nine tenths of a cycle, of a loop that widened
  CHECK(x[1] == Approx(work).margin(0.06));
  CHECK(x[2] == Approx(x[1]).margin(0.03));
  CHECK(x[3] == Approx((1 / 0.81 - 1) / (2 / 0.81)).margin(0.02));
}

TEST_CASE("CyclicWarning: needs a record of cycles or a third turn", "[warning][cyclic]") {
  // Loading to 20 kPa, back to 0, and up again: a loop of unloading.
  const auto run = [](double cycle) {
    CyclicWarning warning(true);
    for (int i = 0; i <= 250; ++i) {
      State s;
      s.time_s = i;
      s.q = 2e2 * (i <= 100 ? i : i <= 200 ? 200 - i : i - 200);
      s.p_eff = 1e5 - 2e2 * i;
      s.strain = {i * 1e-5, -i * 5e-6};
      s.cycle = cycle;
      warning.add(s);
    }
    return warning.numbers().has_value();
  };
  CHECK_FALSE(run(kMissing));
  CHECK(run(0));
}

TEST_CASE("CyclicWarning: loading up to the cycles is no cycle", "[warning][cyclic]") {
  // q grows to 50 kPa while p′ falls by a third, and cycles between 40 and 50 kPa change nothing.
  CyclicWarning warning(true);
  int reading = 0;
  const auto apply_state = [&](double q, double p, double axial) {
    State s;
    s.time_s = reading++;
    s.q = q;
    s.p_eff = p;
    s.strain = {axial, -axial / 2};
    warning.add(s);
  };
  for (int i = 0; i <= 100; ++i) apply_state(500 * i, 1e5 - 333 * i, i * 1e-5);
  for (int i = 0; i <= 100; ++i) {
    apply_state(4.5e4 + 5e3 * std::cos(i * kPi / 20), 6.6e4, 1e-3);
    CHECK_FALSE(warning.is_imminent());
    if (warning.cycles() < 2) CHECK_FALSE(warning.numbers());
  }
  CHECK(warning.is_cyclic());
}

TEST_CASE("CyclicWarning: starts again when the load changes", "[warning][cyclic]") {
  CyclicWarning warning(true);
  CyclicPath path{.left = shakes_down};
  apply(warning, path, 8);
  REQUIRE(warning.numbers());
  SECTION("larger amplitude") {
    path.q_a_pa *= 1.5;
    CHECK(std::isnan(apply(warning, path, 9)));
    CHECK(warning.restart() == CyclicWarning::Restart::larger_load);
    CHECK(warning.restarted_at_cycles() == Approx(8).margin(0.6));
  }
  SECTION("smaller amplitude") {
    path.q_a_pa *= 0.7;
    CHECK(std::isnan(apply(warning, path, 9)));
    CHECK(warning.restart() == CyclicWarning::Restart::smaller_load);
  }
  SECTION("rest of two cycles") {
    State held = path.next();
    for (int i = 0; i < 160; ++i) {
      held.time_s = path.reading++;
      warning.add(held);
    }
    CHECK(warning.restart() == CyclicWarning::Restart::rest);
  }
  CHECK_FALSE(warning.numbers());
  CHECK_FALSE(warning.is_imminent());
  CHECK(std::isnan(apply(warning, path, 14)));
  CHECK(warning.numbers());
}

TEST_CASE("CyclicWarning: a change of a tenth of the amplitude is no restart",
          "[warning][cyclic]") {
  CyclicWarning warning(true);
  CyclicPath path{.left = shakes_down};
  apply(warning, path, 12);
  path.q_a_pa *= 1.1;
  CHECK(std::isnan(apply(warning, path, 20)));
  CHECK(warning.restart() == CyclicWarning::Restart::none);
}

TEST_CASE("CyclicWarning: withdraws when the growth ends", "[warning][cyclic]") {
  CyclicWarning warning(true);
  // To 0.4 p₀ within one cycle, and no further.
  CyclicPath path{.left = [](double n) { return n < 4 ? 1.0 : std::max(0.4, 1 - 0.6 * (n - 4)); }};
  CHECK(apply(warning, path, 5.5) > 4);
  CHECK(warning.is_imminent());
  apply(warning, path, 9);
  CHECK_FALSE(warning.is_imminent());
  CHECK(warning.probability() < warning_limits::kWithdraw);
}

TEST_CASE("CyclicWarning: keeps no warning across an interruption", "[warning][cyclic]") {
  CyclicWarning warning(true);
  CyclicPath path{.left = flows};
  apply(warning, path, 9);
  REQUIRE(warning.is_imminent());
  warning.interrupt();
  CHECK_FALSE(warning.is_imminent());
  CHECK_FALSE(warning.numbers());
  CHECK(warning.restart() == CyclicWarning::Restart::interruption);
  // The next cycle is not compared with the virtual one.
  CHECK(std::isnan(apply(warning, path, 9.8)));
}

TEST_CASE("LoadBranch: has a limited number of samples and interpolates", "[warning][cyclic]") {
  LoadBranch branch(1);
  for (int i = 0; i < 1000; ++i)
    branch.add(
        {.q = i * 10.0, .strain = i * 1e-5, .work = 0, .s = 0, .growth = i == 500 ? 1.0 : 0});
  CHECK(branch.samples().size() <= LoadBranch::kMaxSamples);
  CHECK(branch.samples().size() > 20);
  CHECK(branch.at(4321, 0)->strain == Approx(4.321e-3).epsilon(1e-6));
  CHECK_FALSE(branch.at(11000, 100));
  CHECK(branch.at(10050, 100));
  double growth = 0;
  for (const auto& sample : branch.samples()) growth = std::max(growth, sample.growth);
  CHECK(growth == 1);
}

TEST_CASE("describe: has words for each restart of the cyclic warning", "[warning][cyclic]") {
  CHECK(describe(CyclicWarning::Restart::larger_load) == "the load became larger");
  CHECK(describe(CyclicWarning::Restart::smaller_load) == "the load became smaller");
  CHECK(describe(CyclicWarning::Restart::rest) == "the load was constant for longer than a cycle");
  CHECK(describe(CyclicWarning::Restart::interruption) == "readings were interrupted");
  CHECK(describe(CyclicWarning::Restart::none).empty());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/total_uncertainty.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace triax::lab;

namespace {

Instant onset(double half_width) {
  Instant at{.reading = 100, .q_pa = 60e3, .p_eff_pa = 100e3, .pore_pressure_pa = 350e3};
  at.interval = StressInterval{.q_pa = {59.5e3, 60.5e3},
                               .p_eff_pa = {99e3, 101e3},
                               .eta = {0.6 - half_width, 0.6 + half_width}};
  return at;
}

double share_of(const TotalUncertainty& total, const std::string& name) {
  for (const UncertaintySource& source : total.budget)
    if (source.name == name) return source.share;
  return -1;
}

}  // namespace

TEST_CASE("total_uncertainty: equals a Monte Carlo evaluation of its errors") {
  // Repeatability of almost nothing; force, area and both pressures drawn from their rectangles.
  const auto total = total_uncertainty(onset(1e-9), 0.07);
  REQUIRE(total);
  std::mt19937_64 rng(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  constexpr int kDraws = 200000;
  double sum = 0, square = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double force = 1 + 0.01 * unit(rng), diameter = 0.07 + 1e-4 * unit(rng);
    const double q = 60e3 * force * 0.07 * 0.07 / (diameter * diameter);
    const double cell = 100e3 - 20e3 + 350e3;
    const double cell_read = cell + (500 + 1e-3 * cell) * unit(rng);
    const double u = 350e3 + (500 + 350) * unit(rng);
    const double eta = q / (cell_read + q / 3 - u);
    sum += eta;
    square += eta * eta;
  }
  const double mean = sum / kDraws, deviation = std::sqrt(square / kDraws - mean * mean);
  CHECK((total->interval.eta.high - total->interval.eta.low) / 2 / 1.96 ==
        Approx(deviation).epsilon(0.01));
}

TEST_CASE("total_uncertainty: the budget adds up to one, largest first") {
  const auto total = total_uncertainty(onset(0.01), 0.07);
  REQUIRE(total);
  REQUIRE(total->budget.size() == 5);
  double sum = 0;
  for (std::size_t i = 0; i < total->budget.size(); ++i) {
    sum += total->budget[i].share;
    if (i > 0) CHECK(total->budget[i - 1].share >= total->budget[i].share);
  }
  CHECK(sum == Approx(1));
  // δη/η = 1 − η/3 = 0.8 of the force, whose 1 % is 0.58 % as a standard uncertainty.
  const double force = 0.6 * 0.8 * 0.01 / std::sqrt(3.0), own = 0.01 / 1.96;
  CHECK(share_of(*total, "load cell") / share_of(*total, "readings and place of the onset") ==
        Approx(force * force / (own * own)).epsilon(1e-6));
}

TEST_CASE("total_uncertainty: holds the interval of repeatability") {
  for (const double half_width : {0.001, 0.01, 0.1}) {
    const Instant at = onset(half_width);
    const auto total = total_uncertainty(at, std::nullopt);
    REQUIRE(total);
    CHECK(total->interval.eta.low < at.interval->eta.low);
    CHECK(total->interval.eta.high > at.interval->eta.high);
    CHECK(total->interval.q_pa.low < at.interval->q_pa.low);
    CHECK(total->interval.p_eff_pa.high > at.interval->p_eff_pa.high);
  }
}

TEST_CASE("total_uncertainty: larger at small p', empty without an interval") {
  Instant small = onset(1e-9);
  small.q_pa = 6e3;
  small.p_eff_pa = 10e3;
  const auto at_10_kpa = total_uncertainty(small, 0.07),
             at_100_kpa = total_uncertainty(onset(1e-9), 0.07);
  REQUIRE(at_10_kpa);
  CHECK(at_10_kpa->interval.eta.high - 0.6 > 3 * (at_100_kpa->interval.eta.high - 0.6));
  CHECK(at_10_kpa->budget.front().name.find("transducer") != std::string::npos);
  Instant without = onset(0.01);
  without.interval.reset();
  CHECK_FALSE(total_uncertainty(without, 0.07));
  Instant nothing = onset(0.01);
  nothing.p_eff_pa = 0;
  CHECK_FALSE(total_uncertainty(nothing, 0.07));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/onset_refiner.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace triax::lab;

namespace {

constexpr double kTopOfHistory = 2000;

/// q passes a smooth top at kTopOfHistory, asymmetric as that of a test: x exp(1 − x).
PathSample sample(int i, double noise, std::mt19937_64& rng) {
  std::normal_distribution<double> unit(0, 1);
  const double x = i / kTopOfHistory;
  PathSample s;
  s.signal[PathSample::reading] = i;
  s.signal[PathSample::progress] = i;
  s.signal[PathSample::q] = 100e3 * x * std::exp(1 - x) + noise * unit(rng);
  s.signal[PathSample::p_eff] = 200e3 - 30.0 * i + noise * unit(rng);
  s.signal[PathSample::axial_strain] = 2e-6 * i;
  return s;
}

}  // namespace

TEST_CASE("an onset found late and a hundred readings beside the top is placed within few") {
  double worst = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 rng(seed);
    PathHistory history;
    OnsetRefiner refiner;
    for (int i = 0; i < 4000; ++i) {
      history.add(sample(i, 80, rng));
      if (i == 2400)
        refiner.begin(kTopOfHistory + 100, Witness::second_order_work, history);
      else
        refiner.follow(history);
    }
    refiner.finish(history, history.last_reading());
    REQUIRE(refiner.onset());
    worst = std::max(worst, std::fabs(refiner.onset()->point.reading - kTopOfHistory));
  }
  CHECK(worst < 40);  // the scatter of a single window of the monitor is several times that
}

TEST_CASE("readings of a run-away do not move the onset before it") {
  std::mt19937_64 rng(4);
  PathHistory history;
  OnsetRefiner refiner;
  for (int i = 0; i < 2300; ++i) {
    PathSample s = sample(i, 20, rng);
    if (i >= 2250) s.signal[PathSample::q] = 1e3;  // within one scan
    history.add(s);
  }
  refiner.begin(kTopOfHistory - 50, Witness::second_order_work, history);
  refiner.finish(history, 2249);
  REQUIRE(refiner.onset());
  CHECK(std::fabs(refiner.onset()->point.reading - kTopOfHistory) < 40);
  CHECK_FALSE(refiner.active());
}

TEST_CASE("where nothing turns no onset is given") {
  PathHistory history;
  std::mt19937_64 rng(5);
  for (int i = 0; i < 500; ++i) history.add(sample(i, 0, rng));
  OnsetRefiner refiner;
  refiner.begin(400, Witness::second_order_work, history);
  refiner.finish(history, history.last_reading());
  CHECK_FALSE(refiner.onset());
}

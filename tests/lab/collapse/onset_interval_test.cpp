// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/onset_interval.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "lab/collapse/onset_fit.hpp"

using namespace triax::lab;

namespace {

constexpr double kNoise = 500;

/// p′ falls by 100 Pa a reading, q passes a parabola's top at `top`.
PathHistory history_of(int readings, double top, double bend, double noise,
                       std::uint64_t seed = 1) {
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> unit(0, 1);
  PathHistory history;
  for (int i = 0; i < readings; ++i) {
    PathSample sample;
    auto& s = sample.signal;
    s[PathSample::reading] = s[PathSample::progress] = i;
    s[PathSample::q] = 60e3 - bend * (i - top) * (i - top) + noise * unit(rng);
    s[PathSample::p_eff] = 100e3 - 100.0 * (i - top) + noise * unit(rng);
    s[PathSample::axial_strain] = 1e-4 * i;
    history.add(sample);
  }
  return history;
}

PathPoint onset_at(double reading) {
  PathPoint p;
  p.reading = reading;
  p.q = 60e3;
  p.p_eff = 100e3;
  return p;
}

}  // namespace

TEST_CASE("the interval is as wide as the path is long over the readings of the onset") {
  const auto at = interval_over(history_of(200, 100, 0, 0), onset_at(100), {80, 130}, false);
  REQUIRE(at);
  CHECK(at->p_eff_pa.low == Approx(97e3));
  CHECK(at->p_eff_pa.high == Approx(102e3));
  CHECK(at->eta.low == Approx(60.0 / 102));
  CHECK(at->eta.high == Approx(60.0 / 97));
  CHECK(at->q_pa.high - at->q_pa.low < 1);
}

TEST_CASE("in white noise 95 % of the intervals hold the state that was") {
  int q = 0, p = 0, eta = 0;
  constexpr int kTimes = 400;
  for (int seed = 1; seed <= kTimes; ++seed) {
    const auto history = history_of(200, 100, 0.1, kNoise, static_cast<std::uint64_t>(seed));
    const PathPoint onset = values_at(history.between(88, 112), 100);
    const auto at = interval_over(history, onset, {100, 100}, false);
    REQUIRE(at);
    q += at->q_pa.holds(60e3);
    p += at->p_eff_pa.holds(100e3);
    eta += at->eta.holds(0.6);
  }
  for (const int held : {q, p, eta}) {
    CHECK(held > 0.90 * kTimes);
    CHECK(held < 0.999 * kTimes);
  }
}

TEST_CASE("between single readings the interval is that gap") {
  PathHistory history = history_of(20, 10.4, 1000, 0);
  PathPoint onset = onset_at(10);
  onset.q = 60e3 - 1000 * 0.16;
  onset.p_eff = 100e3 + 40;
  const auto at = interval_over(history, onset, {9, 11}, true);
  REQUIRE(at);
  CHECK(at->q_pa.low == Approx(60e3 - 1000 * 1.96));
  // Lines through the two readings before and the two after meet there.
  CHECK(at->q_pa.high == Approx(60e3 + 740));
  CHECK(at->p_eff_pa.low == Approx(100e3 - 60));
  CHECK(at->p_eff_pa.high == Approx(100e3 + 140));
}

TEST_CASE("no curve is laid across the fall that ends the path") {
  PathHistory history = history_of(100, 90, 0, 0);
  PathSample fallen;
  for (int i = 100; i < 106; ++i) {
    fallen.signal = {static_cast<double>(i), static_cast<double>(i), 5e3, 2e3, 0.1, 0, 0};
    history.add(fallen);
  }
  const auto at = interval_over(history, onset_at(95), {92, 99, 99}, false);
  REQUIRE(at);
  CHECK(at->q_pa.high - at->q_pa.low < 1);
  CHECK(at->p_eff_pa.low == Approx(99.1e3));
  CHECK(at->p_eff_pa.high == Approx(100e3));
}

TEST_CASE("the peak of a concave q between two readings lies below the lines before and after") {
  PathHistory history = history_of(20, 10.5, 1000, 0);
  PathPoint onset = onset_at(10);
  onset.q = 60e3 - 1000 * 0.25;
  const auto at = interval_over(history, onset, {10, 11}, true);
  REQUIRE(at);
  CHECK(at->q_pa.holds(60e3));
  CHECK(at->q_pa.high < 61e3);
}

TEST_CASE("of readings that fall from a largest one on, that one may have hidden the turn") {
  PathHistory history = history_of(20, 9.4, 1000, 0);
  const auto at = interval_over(history, onset_at(10), {10, 12}, true);
  REQUIRE(at);
  CHECK(at->p_eff_pa.high == Approx(100e3 + 140));
}

TEST_CASE("an onset long ago, known in blocks of many readings, has an interval, too") {
  const auto history = history_of(5000, 100, 0, 200);
  REQUIRE(history.between(88, 112).size() < 8);
  const auto at = interval_over(history, onset_at(100), {80, 130}, false);
  REQUIRE(at);
  CHECK(at->p_eff_pa.holds(100e3));
  CHECK(at->p_eff_pa.high - at->p_eff_pa.low > 4e3);
}

TEST_CASE("what the history does not reach has no interval") {
  CHECK_FALSE(interval_over(PathHistory(), onset_at(10), {5, 15}, false));
  CHECK_FALSE(interval_over(history_of(5, 2, 1, 0), onset_at(2), {1, 3}, false));
}

TEST_CASE("of three readings the parabola's vertex is the onset, with all values there") {
  PathHistory history = history_of(20, 10.4, 1000, 0);
  PathPoint onset = onset_at(10);
  onset.window_readings = BlockPyramid::kBlocks;
  const PathPoint peak = peak_of_readings(onset, history);
  CHECK(peak.reading == Approx(10.4));
  CHECK(peak.q == Approx(60e3));
  CHECK(peak.p_eff == Approx(100e3));
  CHECK(peak.axial_strain == Approx(10.4e-4));
  onset.window_readings *= 2;
  CHECK(peak_of_readings(onset, history).reading == 10);
  onset.window_readings = BlockPyramid::kBlocks;
  onset.reading = 5;  // q rises there
  CHECK(peak_of_readings(onset, history).reading == 5);
}

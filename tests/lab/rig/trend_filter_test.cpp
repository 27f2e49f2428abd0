// SPDX-License-Identifier: GPL-3.0-or-later
// The servo's smoothing: exact on what is steady, quiet on noise.
#include "lab/rig/trend_filter.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using triax::lab::TrendFilter;

TEST_CASE("a ramp is followed without a lag, after a wrong start, too") {
  TrendFilter filter(10);
  filter.start(3, 0);
  for (int i = 1; i <= 2000; ++i) filter.take(0.1 * i, 0.5);
  CHECK(filter.level() == Approx(200));
  CHECK(filter.expected(2) == Approx(200.4));
}

TEST_CASE("a step is come to in critical damping: one overshoot of the known size") {
  // Of y'' + 2/T y' + y/T^2 driven through level and trend: 1 - (1 - t/T) exp(-t/T).
  TrendFilter filter(10);
  filter.start(0, 0);
  double most = 0;
  for (int i = 1; i <= 20000; ++i) {
    filter.take(1, 0.005);
    const double t = 0.005 * i / 10;
    if (i % 1000 == 0) CHECK(filter.level() == Approx(1 - (1 - t) * std::exp(-t)).margin(1e-3));
    most = std::max(most, filter.level());
  }
  CHECK(most == Approx(1 + std::exp(-2.0)).margin(1e-3));
}

TEST_CASE("of white noise the square root of five quarters of dt over the time constant stays") {
  TrendFilter filter(10);
  filter.start(0, 0);
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  double square = 0;
  constexpr int kLooks = 200000;
  for (int i = 0; i < kLooks; ++i) {
    filter.take(noise(random), 0.1);
    square += filter.level() * filter.level();
  }
  CHECK(std::sqrt(square / kLooks) == Approx(std::sqrt(1.25 * 0.1 / 10)).epsilon(0.05));
}

TEST_CASE("without a time constant it is not active") {
  CHECK_FALSE(TrendFilter().active());
  CHECK(TrendFilter(1).active());
}

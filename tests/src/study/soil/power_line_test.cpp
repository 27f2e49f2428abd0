// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/power_line.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/devices/noise.hpp"

using namespace triax::study;

namespace {

/// e = 0.95 − 0.04 (p′/100)^0.6 with so much noise, at 5 to 1500 kPa.
std::vector<FitPoint> points(int count, double noise) {
  std::vector<FitPoint> all;
  for (int i = 0; i < count; ++i) {
    const double p = 5 * std::pow(300.0, i / (count - 1.0));
    const double e = 0.95 - 0.04 * std::pow(p / 100, 0.6) +
                     noise * triax::lab::standard_normal(3, 1, static_cast<std::uint64_t>(i));
    all.push_back({std::log(p), e, 0, 0.002});
  }
  return all;
}

}  // namespace

TEST_CASE("Points on a power line give it back, and the intervals hold it") {
  const auto line = fit_power_line(points(12, 0.002), std::nullopt);
  REQUIRE(line);
  CHECK_FALSE(line->exponent_held);
  CHECK(line->exponent.holds(0.6));
  CHECK(line->void_ratio.holds(0.95));
  CHECK(line->slope.holds(0.04));
  CHECK(line->at(100) == Approx(0.91).margin(0.004));
}

TEST_CASE("An exponent that the points leave open, or that is given, is held") {
  auto close = points(12, 0.002);
  for (auto& p : close) p.x = std::log(100.0) + 0.02 * p.x;
  const auto open = fit_power_line(close, std::nullopt);
  REQUIRE(open);
  CHECK(open->exponent_held);
  CHECK(open->exponent.value == kUsualExponent);
  const auto given = fit_power_line(points(12, 0), 0.6);
  REQUIRE(given);
  CHECK(given->void_ratio.value == Approx(0.95));
  CHECK(given->slope.value == Approx(0.04));
  CHECK(given->exponent.low == given->exponent.high);
}

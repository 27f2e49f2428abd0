// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/root_time.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace triax::study;

namespace {

constexpr double kDiameter = 0.05, kHeight = 2 * kDiameter;

/// Terzaghi's degree of consolidation, drained at one end.
double degree(double factor) {
  double sum = 0;
  for (int m = 0; m < 400; ++m) {
    const double root = std::numbers::pi / 2 * (2 * m + 1);
    sum += 2 / (root * root) * std::exp(-root * root * factor);
  }
  return 1 - sum;
}

std::vector<ConsolidationPoint> terzaghi(double c_v, double jump) {
  std::vector<ConsolidationPoint> points;
  const double end = 4 * kHeight * kHeight / c_v;  // T = 4
  for (int i = 0; i <= 2000; ++i) {
    const double time = end * i / 2000;
    points.push_back({time, (i > 0 ? jump : 0) + 12e-6 * degree(c_v * time / (kHeight * kHeight))});
  }
  return points;
}

}  // namespace

TEST_CASE("t100, t90, t50 and c_v of Terzaghi's curve, with and without what jumped at once") {
  const double c_v = 3e-7, unit = kHeight * kHeight / c_v;
  for (const double jump : {0.0, 1.5e-6}) {
    const auto fit = root_time(terzaghi(c_v, jump));
    REQUIRE(fit);
    CHECK(fit->zero == Approx(jump).margin(1e-7));
    CHECK(fit->t100_s == Approx(std::numbers::pi / 4 * unit).epsilon(0.01));
    REQUIRE(fit->t90_s);
    CHECK(*fit->t90_s == Approx(0.848 * unit).epsilon(0.02));
    REQUIRE(fit->t50_s);
    CHECK(*fit->t50_s == Approx(0.197 * unit).epsilon(0.02));
    CHECK(coefficient_of_consolidation(kDiameter, DrainageBoundary::one_end, fit->t100_s) ==
          Approx(c_v).epsilon(0.01));
  }
}

TEST_CASE("readings that crowd at the end do not bend the line") {
  auto points = terzaghi(3e-7, 0);
  const auto even = root_time(points);
  std::vector<ConsolidationPoint> crowded;
  for (std::size_t i = 1; i < points.size(); ++i) {
    crowded.push_back(points[i - 1]);
    for (std::size_t k = 1; i > 1000 && k < 10; ++k) {
      const double part = static_cast<double>(k) / 10;
      const auto &a = points[i - 1], &b = points[i];
      crowded.push_back(
          {a.time_s + part * (b.time_s - a.time_s), a.outflow + part * (b.outflow - a.outflow)});
    }
  }
  crowded.push_back(points.back());
  CHECK(root_time(crowded)->t100_s == Approx(even->t100_s).epsilon(1e-6));
}

TEST_CASE("what is no consolidation has no t100") {
  CHECK_FALSE(root_time({}));
  CHECK_FALSE(root_time({{0, 0}, {1, 1}, {2, 1}}));
  std::vector<ConsolidationPoint> still(100);
  for (std::size_t i = 0; i < still.size(); ++i) still[i].time_s = static_cast<double>(i);
  CHECK_FALSE(root_time(still));
  CHECK(drainage_boundary_from("both ends") == DrainageBoundary::both_ends);
  CHECK_FALSE(drainage_boundary_from("both"));
  CHECK(factors_of(DrainageBoundary::sides_and_both_ends).lambda == 100);
}

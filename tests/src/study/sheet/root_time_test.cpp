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

namespace {

/// Of ∇²w = −1 in a cylinder of D = 1, w = 0 at its side and at z = ±half: the mean of w. Its
/// excess pressure by a steady rate of loading is that over c_v.
double mean_of_drained_cylinder(double half) {
  double sum = 0;
  for (int j = 1; j < 200; j += 2) {
    const double k = j * std::numbers::pi / (2 * half), x = k / 2;
    const double ratio = std::cyl_bessel_i(1.0, x) / std::cyl_bessel_i(0.0, x);
    sum += 8 / std::pow(j * std::numbers::pi * k, 2) * (1 - 2 * ratio / x);
  }
  return sum;
}

}  // namespace

// Table 1 of BS 1377-8 from theory, for H = 2 D = 2. Early on U = (2/√π) S √(c_v t), S = drained
// surface over volume, so that λ = 4 S²; the mean excess pressure of a steady rate is m/c_v, and
// 95 % of it have gone at t_f = 20 m/c_v (Bishop and Henkel, 1962): F = 20 m λ/π.
TEST_CASE("the factors of a drained test follow from theory") {
  struct Row {
    DrainageBoundary boundary;
    double surface, mean;
  };
  using enum DrainageBoundary;
  for (const auto& [boundary, surface, mean] :
       {Row{one_end, 0.5, 4.0 / 3}, Row{both_ends, 1, 1.0 / 3}, Row{sides, 4, 1.0 / 32},
        Row{sides_and_one_end, 4.5, mean_of_drained_cylinder(2)},
        Row{sides_and_both_ends, 5, mean_of_drained_cylinder(1)}}) {
    INFO(to_string(boundary));
    const auto factors = factors_of(boundary);
    CHECK(factors.lambda == Approx(4 * surface * surface).epsilon(0.0125));  // 80 stands for 81
    CHECK(factors.drained == Approx(20 * mean * factors.lambda / std::numbers::pi).epsilon(0.01));
  }
}

// Undrained t_f is a multiple of D²/c_v (Blight, 1963), one without and one with drains at the
// side: F/λ is the same for either kind.
TEST_CASE("the factors of an undrained test are one time without and one with side drains") {
  using enum DrainageBoundary;
  const auto share = [](DrainageBoundary at) {
    return factors_of(at).undrained / factors_of(at).lambda;
  };
  CHECK(share(both_ends) == Approx(share(one_end)).epsilon(0.02));
  CHECK(share(sides_and_one_end) == Approx(share(sides)).epsilon(0.04));
  CHECK(share(sides_and_both_ends) == Approx(share(sides)).epsilon(0.04));
}

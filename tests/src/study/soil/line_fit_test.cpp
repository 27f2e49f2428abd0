// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/line_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/devices/noise.hpp"

using namespace triax::study;

TEST_CASE("A line through points with equal errors of y is that of ordinary least squares") {
  // By hand: x 0 1 2 3, y 1 3 4 8: mean 1.5, 4; Sxx 5, Sxy 11; b 2.2, a 0.7; residuals 0.3 0.1 -1.1
  // 0.7, their squares 1.8, s2 0.9; var b 0.9/5, var a 0.9 (1/4 + 2.25/5).
  const std::vector<FitPoint> points = {
      {0, 1, 0, 0.5}, {1, 3, 0, 0.5}, {2, 4, 0, 0.5}, {3, 8, 0, 0.5}};
  const auto fit = fit_line(points);
  REQUIRE(fit);
  CHECK(fit->b == Approx(2.2));
  CHECK(fit->a == Approx(0.7));
  CHECK(fit->var_b == Approx(0.18));
  CHECK(fit->var_a == Approx(0.63));
  CHECK(fit->cov_ab == Approx(-0.27));
  CHECK(fit->slope().high == Approx(2.2 + 4.30265 * std::sqrt(0.18)));
}

TEST_CASE("York's line of Pearson's data with weights is the published one") {
  // Pearson's ten points with York's weights, York et al. (2004): a 5.47991, b -0.480533.
  const double x[] = {0, 0.9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4};
  const double y[] = {5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5};
  const double wx[] = {1000, 1000, 500, 800, 200, 80, 60, 20, 1.8, 1};
  const double wy[] = {1, 1.8, 4, 8, 20, 20, 70, 70, 100, 500};
  std::vector<FitPoint> points;
  for (int i = 0; i < 10; ++i)
    points.push_back({x[i], y[i], 1 / std::sqrt(wx[i]), 1 / std::sqrt(wy[i])});
  const auto fit = fit_line_with_scatter(points, 0);
  REQUIRE(fit);
  CHECK(fit->a == Approx(5.47991).epsilon(1e-5));
  CHECK(fit->b == Approx(-0.480533).epsilon(1e-5));
}

TEST_CASE("A scatter beyond the errors is found and balances the sum of squares") {
  std::vector<FitPoint> points;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const double at = static_cast<double>(i);
    points.push_back({at, 2 * at + 3 * triax::lab::standard_normal(5, 1, i), 0, 0.1});
  }
  const auto fit = fit_line(points);
  REQUIRE(fit);
  CHECK(fit->scatter == Approx(3).epsilon(0.3));
  CHECK(weighted_residuals(*fit, points) == Approx(38).epsilon(1e-6));
}

TEST_CASE("Too few points, or points at one x, have no line") {
  CHECK_FALSE(fit_line({{0, 1}, {1, 2}}));
  CHECK_FALSE(fit_line({{2, 1}, {2, 2}, {2, 3}}));
  CHECK_FALSE(fit_mean({{0, 1}}));
}

TEST_CASE("A mean of equal weights has the variance of the textbook") {
  // 1 2 3 6: mean 3, s2 14/3, variance of the mean 7/6.
  const auto fit = fit_mean({{0, 1, 0, 1}, {0, 2, 0, 1}, {0, 3, 0, 1}, {0, 6, 0, 1}});
  REQUIRE(fit);
  CHECK(fit->mean.value == Approx(3));
  CHECK(fit->mean.error == Approx(std::sqrt(7.0 / 6)));
  CHECK(fit->mean.high == Approx(3 + 3.18245 * std::sqrt(7.0 / 6)));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/runge_kutta.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::sim;

namespace {

/// Error of y′ = −2 t y², y(0) = 1 (y = 1/(1 + t²)) at t = 1 with n steps.
double error_of(const Tableau& t, int n, double* estimate = nullptr) {
  const auto slope = [](double time, double y) { return -2 * time * y * y; };
  double y = 1;
  for (int i = 0; i < n; ++i) {
    const double h = 1.0 / n, start = i * h;
    double k[Tableau::kMostStages] = {}, result = y;
    for (int row = 0; row < t.rows; ++row) {
      double at = y, c = 0;
      for (int j = 0; j < std::min(row, t.evaluations); ++j) {
        at += h * t.a[row][j] * k[j];
        c += t.a[row][j];
      }
      if (row < t.evaluations) k[row] = slope(start + c * h, at);
      result = at;
    }
    if (estimate != nullptr && i == 0) {
      *estimate = 0;
      for (int j = 0; j < t.evaluations; ++j) *estimate += h * t.error[j] * k[j];
    }
    y = result;
  }
  return std::abs(y - 0.5);
}

}  // namespace

TEST_CASE("the pairs have the order they claim, and their estimate is one order lower") {
  for (const Tableau& t : {kImprovedEuler, kDormandPrince}) {
    INFO("order " << t.order);
    CHECK(std::log2(error_of(t, 20) / error_of(t, 40)) == Approx(t.order).margin(0.4));
    double sum = 0;
    for (const double weight : t.error) sum += weight;
    CHECK(sum == Approx(0).margin(1e-15));  // a constant slope has no error
    double coarse = 0, fine = 0;
    error_of(t, 40, &coarse);
    error_of(t, 80, &fine);
    CHECK(std::log2(std::abs(coarse / fine)) > t.order - 0.4);
  }
}

TEST_CASE("fine tolerances take the pair of high order") {
  CHECK(tableau_for(1e-10).order == 5);
  CHECK(tableau_for(1e-6).order == 5);
  CHECK(tableau_for(1e-4).order == 2);
}

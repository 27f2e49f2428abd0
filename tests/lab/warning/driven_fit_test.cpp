// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/driven_fit.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;

namespace {

/// A fit with given coefficients, at η = 0.5, 0.1 of η as its distance.
DrivenFit with(const DrivenFit::Columns& y, const DrivenFit::Columns& beside) {
  return {.now = 0.5, .distance = 0.1, .y = y, .beside = beside};
}

}  // namespace

TEST_CASE("what lies on the model comes back from its integrals, whatever the constant") {
  // dy/dx = 2 − 3ξ + 0.5ξ², dbeside/dx = −1 + ξ, with η = 5x, now = 0.5 and a distance of 0.1.
  std::vector<PathMean> means;
  PathMean m{.readings = 1, .y = 40, .beside = 70};
  constexpr double kStep = 1e-4;
  for (int i = 0; i <= 1000; ++i) {
    m.x = kStep * i;
    m.eta = 5 * m.x;
    if (i % 25 == 0) means.push_back(m);
    const double middle = 5 * (m.x + kStep / 2), xi = (middle - 0.5) / 0.1;
    m.y += (2 - 3 * xi + 0.5 * xi * xi) * kStep;
    m.beside += (-1 + xi) * kStep;
    double power = 1;
    for (double& weighted : m.weighted) weighted += power * kStep, power *= middle;
  }
  const auto fit = fit_driven(means, 0, 0.5, 0.1, 4);
  REQUIRE(fit);
  CHECK(fit->y[1] == Approx(2).epsilon(1e-3));
  CHECK(fit->y[2] == Approx(-3).epsilon(1e-3));
  CHECK(fit->y[3] == Approx(0.5).epsilon(1e-2));
  CHECK(fit->beside[1] == Approx(-1).epsilon(1e-3));
  CHECK(fit->beside[2] == Approx(1).epsilon(1e-3));
  CHECK_FALSE(fit_driven(means, means.size() - 5, 0.5, 0.1, 4));  // fewer than terms + 2
  const std::vector<PathMean> still(20, means.back());
  CHECK_FALSE(fit_driven(still, 0, 0.5, 0.1, 3));  // nothing moved
}

TEST_CASE("the root is the nearest at which dy/dx falls, and none where it grows") {
  CHECK(*with({0, 2, -4, 0}, DrivenFit::Columns::Zero()).root() == Approx(0.5));
  // (ξ − 1)(ξ − 3): falls through zero at 1, grows through it at 3
  CHECK(*with({0, 3, -4, 1}, DrivenFit::Columns::Zero()).root() == Approx(1));
  CHECK_FALSE(with({0, 2, 1, 0}, DrivenFit::Columns::Zero()).root());
  CHECK_FALSE(with({0, 2, 0, 1}, DrivenFit::Columns::Zero()).root());
}

TEST_CASE("the tangent of the path's slope times root η") {
  // r = −(dy/dp′) √η, d ln r/dξ = −1 − 0.25 + 0.5 · 0.1/0.5
  const auto root = with({0, 2, -2, 0}, {0, -4, -1, 0}).root_of_slope();
  REQUIRE(root);
  CHECK(*root == Approx(1 / (1 + 0.25 - 0.1)));
  CHECK_FALSE(with({0, 2, -2, 0}, {0, 4, 0, 0}).root_of_slope());    // p′ grows
  CHECK_FALSE(with({0, -2, -2, 0}, {0, -4, 0, 0}).root_of_slope());  // y falls
}

TEST_CASE("normalised work of an undrained increment, and in extension the same") {
  // dq = 3, dp′ = −4: r = 0.75, r/√(4.5 + r²)
  CHECK(with({0, 3, 0, 0}, {0, -4, 0, 0}).work_along_path(1, 1) ==
        Approx(0.75 / std::sqrt(4.5 + 0.75 * 0.75)));
  CHECK(with({0, 3, 0, 0}, {0, -4, 0, 0}).work_along_path(1, -1) ==
        Approx(0.75 / std::sqrt(4.5 + 0.75 * 0.75)));
  // R = 0.5, dσ₁′ = 1, dσ₃′ = −1: y = σ₁′ − 2σ₃′, dε₃ = −dε₁; 3/(√3 √3)
  CHECK(with({0, 3, 0, 0}, {0, -1.0 / 3, 0, 0}).work_along_path(0.5, 1) == Approx(1));
}

TEST_CASE("a pore fluid that gives way takes its part of the work along a path") {
  // dq = 3, dp′ = −4: dσ₁′ = −2, dσ₃′ = −5, du = 5; c = 0.01: dε_v = 0.05, dε₃ = −0.475.
  // In extension dq = −3 over dε₁ = −1: dσ₁′ = −6, dσ₃′ = −3, du = 3: dε_v = 0.03, dε₃ = 0.515.
  struct Way {
    double sign, axial, radial, strain;
  };
  for (const Way& w : {Way{1, -2, -5, -0.475}, Way{-1, -6, -3, 0.515}}) {
    DrivenFit fit = with({0, 3, -2, 0}, {0, -4, -1, 0});
    fit.give_way(0.01, 1, w.sign);
    const double work = w.sign * w.axial + 2 * w.radial * w.strain;
    CHECK(fit.y[1] == Approx(work));
    const double later = (-3 + 2 * w.sign) / 3;  // of dσ₃′, a unit of ξ
    CHECK(fit.y[2] == Approx(-2 - 2 * 0.01 * w.radial * later));
    CHECK(fit.y[3] == Approx(-0.01 * later * later));
    CHECK(fit.work_along_path(1, w.sign) ==
          Approx(work / std::sqrt((w.axial * w.axial + 2 * w.radial * w.radial) *
                                  (1 + 2 * w.strain * w.strain))));
  }
  DrivenFit tight = with({0, 3, -2, 0}, {0, -4, -1, 0});
  tight.give_way(0, 1, 1);
  CHECK(tight.y == DrivenFit::Columns(0, 3, -2, 0));
}

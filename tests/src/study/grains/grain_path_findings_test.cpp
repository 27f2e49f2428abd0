// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_path_findings.hpp"

#include <catch2/catch.hpp>

#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

TEST_CASE("second-order work of an increment is that of Eq. (30), whatever R it is split with") {
  sim::GrainPathPoint a, b;
  a.stress = {150e3, 100e3};
  b.stress = {151e3, 98e3};
  a.strain = {0.01, -0.004};
  b.strain = {0.0105, -0.0044};
  // dσ₁ dε₁ + 2 dσ₃ dε₃ = 1000 · 5e-4 + 2 · (−2000)(−4e-4)
  for (const double R : {0.7, 0.825, 1.0, 2.0}) CHECK(second_order_work(a, b, R) == Approx(2.1));
  // On the path itself the second term is nil.
  const auto from = test::path_point(0.001, 10e3, 0.8),
             to = test::path_point(0.002, 8e3, 0.8, 50e3);
  CHECK(second_order_work(from, to, 0.8) == Approx(-2e3 * 1e-3));
}

TEST_CASE("the peak of the control stress is where it is, and it fell") {
  const auto points = test::rising_and_falling(0.8);
  const auto found = path_findings(test::strain_path(0.8), points);
  REQUIRE(found.path_stress);
  CHECK(found.path_stress->point == 20);
  CHECK(found.path_stress->value == Approx(20e3));
  CHECK(found.path_stress->axial_strain == Approx(0.002));
  CHECK(found.path_stress->fell);
  // σ₃ is constant here, so that q and η peak together with it.
  CHECK(found.q->point == 20);
  CHECK(found.q->value == Approx(20e3 + 60e3 / 0.8 - 60e3));
  CHECK(found.eta->value == Approx(points[20].q_pa / points[20].p_pa));
  CHECK(found.most_kinetic_j == 3e-4);
}

TEST_CASE("W2 turns negative in the middle of the first increment across the peak that falls") {
  // Over five points: from point i to i + 5 the stress falls where 3 points up are less than 2
  // down: 1000 (20 − i) < 500 (i + 5 − 20) first at i = 19, whose middle is 19 + 3.
  const auto found = path_findings(test::strain_path(0.8), test::rising_and_falling(0.8));
  REQUIRE(found.first_negative);
  CHECK(*found.first_negative == 22);
}

TEST_CASE("a dip shorter than the window is no loss of stability; one up to the end is") {
  sim::GrainPath path = test::strain_path(1);
  path.samples = 40;  // a window of 5 points
  std::vector<sim::GrainPathPoint> points;
  for (int i = 0; i <= 40; ++i) points.push_back(test::path_point(1e-4 * i, 1e3 * i, 1));
  points[20] = test::path_point(20e-4, 12e3, 1);
  CHECK_FALSE(path_findings(path, points).first_negative);
  auto found = path_findings(path, points);
  CHECK(found.path_stress->point == 40);
  CHECK_FALSE(found.path_stress->fell);
  points.resize(41 - 3);
  for (int i = 35; i < 38; ++i) points[i] = test::path_point(1e-4 * i, 20e3, 1);
  found = path_findings(path, points);
  REQUIRE(found.first_negative);
  CHECK(*found.first_negative == 30 + 3);
  CHECK(found.path_stress->fell);
}

TEST_CASE("in extension peaks are the smallest values") {
  sim::GrainPath path;
  path.strain_rate_per_s = -0.1;
  std::vector<sim::GrainPathPoint> points = {test::path_point(0, 0, 1),
                                             test::path_point(-0.001, -9e3, 1),
                                             test::path_point(-0.002, -6e3, 1)};
  const auto found = path_findings(path, points);
  CHECK(found.q->value == Approx(-9e3));
  CHECK(found.q->fell);
  CHECK_FALSE(found.path_stress);  // of strain paths only
}

TEST_CASE("where p has all but vanished, eta is not looked at") {
  auto points = test::rising_and_falling(1);
  points.push_back(test::path_point(0.005, 100, 1, 50));  // η = 1.2 at p = 83 Pa
  const auto found = path_findings(test::strain_path(1), points);
  CHECK(found.eta->point == 20);
}

TEST_CASE("isotropic paths and empty ones have no peaks") {
  sim::GrainPath path;
  path.kind = sim::GrainPathKind::isotropic;
  const auto found = path_findings(path, test::rising_and_falling(1));
  CHECK_FALSE(found.q);
  CHECK_FALSE(found.eta);
  CHECK(found.most_kinetic_j == 3e-4);
  const auto nothing = path_findings(test::strain_path(1), {});
  CHECK_FALSE(nothing.path_stress);
  CHECK_FALSE(nothing.first_negative);
}

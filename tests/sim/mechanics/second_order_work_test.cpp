// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/second_order_work.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace triax::sim;

namespace {

AxisymmetricStress stress(std::mt19937_64& rng, double scale) {
  std::uniform_real_distribution<double> u(-scale, scale);
  return {u(rng), u(rng)};
}

}  // namespace

TEST_CASE("small-strain work is dq deps_q + dp deps_v") {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 100; ++i) {
    const auto ds = stress(rng, 1e3);
    const auto sample = stress(rng, 1e-4);
    const AxisymmetricStrain de{sample.axial, sample.radial};
    const auto w = second_order_work({{200e3, 100e3}, {}}, ds, de);
    CHECK(w.small_strain ==
          Approx(deviator_stress(ds) * shear_strain(de) + mean_stress(ds) * volumetric_strain(de)));
    CHECK(std::fabs(w.normalised) <= 1);
  }
}

TEST_CASE("Eulerian and semi-Lagrangian forms are one: J times Eq. 10 is Eq. 7") {
  std::mt19937_64 rng(2);
  for (int i = 0; i < 100; ++i) {
    const auto large = stress(rng, 0.2);
    const StretchedState at{{300e3, 120e3}, {large.axial, large.radial}};
    const auto small = stress(rng, 1e-4);
    const auto ds = stress(rng, 1e3);
    const auto w = second_order_work(at, ds, {small.axial, small.radial});
    const double jacobian = 1 - volumetric_strain(at.strain);
    CHECK(w.semi_lagrangian == Approx(jacobian * w.eulerian).epsilon(1e-9).margin(1e-12));
  }
}

TEST_CASE("the finite forms are those of the cylinder whose height and volume were measured") {
  // Eq. (7) by differences: nominal stresses per area of the reference, and the sides of the
  // cylinder, of two states that follow each other.
  struct Side {
    double height, width, axial, lateral;  // λ₁, λ₃, σ₁λ₃², σ₃λ₁λ₃
  };
  const auto cylinder = [](double e1, double ev, const AxisymmetricStress& s) {
    const double height = 1 - e1, width = std::sqrt((1 - ev) / height);
    return Side{height, width, s.axial * width * width, s.radial * height * width};
  };
  const AxisymmetricStress s{300e3, 120e3}, ds{-40, 25};
  const double e1 = 0.15, ev = -0.03, de1 = 2e-6, dev = -7e-7;
  const auto state = [&](double x) {
    return cylinder(e1 + x * de1, ev + x * dev, {s.axial + x * ds.axial, s.radial + x * ds.radial});
  };
  const Side before = state(-0.5), after = state(0.5);
  const double expected = -(after.axial - before.axial) * (after.height - before.height) -
                          2 * (after.lateral - before.lateral) * (after.width - before.width);
  const auto w = second_order_work({s, {e1, (ev - e1) / 2}}, ds, {de1, (dev - de1) / 2});
  CHECK(w.semi_lagrangian == Approx(expected).epsilon(1e-6));
  CHECK(w.eulerian == Approx(expected / (1 - ev)).epsilon(1e-6));
  // The side of the cylinder is not 1 − (ε_v − ε₁)/2: 1.101 against 1.090.
  CHECK(state(0).width == Approx(1.10080).margin(1e-5));
}

TEST_CASE("without strain and without stress the three forms agree") {
  const auto w = second_order_work({}, {2e3, -1e3}, {1e-4, 3e-5});
  CHECK(w.eulerian == Approx(w.small_strain));
  CHECK(w.semi_lagrangian == Approx(w.small_strain));
}

TEST_CASE("normalised work is the cosine between increments, blind to their size") {
  const AxisymmetricStress ds{3e3, -2e3};
  CHECK(second_order_work({}, ds, {3e-5, -2e-5}).normalised == Approx(1));
  CHECK(second_order_work({}, ds, {-3e-5, 2e-5}).normalised == Approx(-1));
  // dq = 0 against a pure shear strain
  CHECK(second_order_work({}, {1e3, 1e3}, {2e-5, -1e-5}).normalised == Approx(0).margin(1e-12));
  CHECK(second_order_work({}, {3e5, -2e5}, {1e-5, 2e-5}).normalised ==
        Approx(second_order_work({}, {3, -2}, {1e-2, 2e-2}).normalised));
  CHECK(second_order_work({}, {}, {1e-5, 0}).normalised == 0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/second_order_work.hpp"

#include <catch2/catch.hpp>
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
    const double stretch_1 = 1 - at.strain.axial, stretch_3 = 1 - at.strain.radial;
    const double jacobian = stretch_1 * stretch_3 * stretch_3;
    CHECK(w.semi_lagrangian == Approx(jacobian * w.eulerian).epsilon(1e-9).margin(1e-12));
  }
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

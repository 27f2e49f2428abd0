// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/sphere.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <stdexcept>

#include "sim/materials/elastic.hpp"
#include "tests/sim/stability/stability_states.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

Interpolated<Tensor> inl2_tensor() { return law<Tensor>(Interpolation::inl2, kInl2); }

}  // namespace

TEST_CASE("directions of the sphere: poles on the hydrostatic axis, azimuth is Lode's angle") {
  const double third = 1 / std::sqrt(3.0);
  CHECK((sphere_direction(0, 1) - Eigen::Vector3d(third, third, third)).norm() < 1e-15);
  const Eigen::Vector3d compression = sphere_direction(std::numbers::pi / 2, 0);
  CHECK(compression(0) == Approx(2 / std::sqrt(6.0)));
  CHECK(compression(1) == Approx(compression(2)));
  const auto law = inl2_tensor();
  const auto response = response_at<Tensor>(law, 70, 0.5, 1.086);
  for (const double polar : {0.3, 1.5, 2.9})
    for (const double azimuth : {0.0, 1.0, 4.0}) {
      const auto probe =
          probe_direction(*response, ProbeKind::stress, sphere_direction(polar, azimuth));
      CHECK(probe.polar == Approx(polar));
      CHECK(probe.azimuth == Approx(azimuth).margin(1e-12));
    }
}

TEST_CASE("least work of elasticity over all directions is Kantorovich's bound") {
  // cos of the angle between v and Cv is at least 2√(λμ)/(λ + μ) with the extreme eigenvalues of C,
  // here 3K and 2G.
  ElasticParameters p;
  p.young_modulus_pa = 40e6;
  p.poisson_ratio = 0.35;
  p.reference_pressure_pa = 100e3;
  const Elastic<Tensor> law(p);
  const double bulk3 = 40e6 / (1 - 2 * 0.35), shear2 = 40e6 / (1 + 0.35);
  const double bound = 2 * std::sqrt(bulk3 * shear2) / (bulk3 + shear2);
  const auto response = response_at<Tensor>(law, 100, 0, 0.8);
  for (const auto kind : {ProbeKind::stress, ProbeKind::strain}) {
    const Sphere sphere = probe_sphere(*response, kind, 12);
    CHECK(sphere.least.normalised == Approx(bound).epsilon(1e-9));
    CHECK(sphere.unstable_share == 0);
    CHECK(sphere.regions == 0);
    CHECK(sphere.probes.size() == 12 * 24);
    CHECK(least_of_all_directions(*response, kind, sphere.least).normalised ==
          Approx(bound).epsilon(1e-9));
  }
}

TEST_CASE("the sphere holds the axisymmetric circle: INL2") {
  const auto law3 = inl2_tensor();
  const auto law2 = inl2();
  const auto response = response_at<Tensor>(law3, 70, 0.6, 1.086);
  const auto prober =
      make_prober(response_at<Axisymmetric>(law2, 70, 0.6, 1.086), ProbeKind::stress);
  for (double angle = 0; angle < 6.28; angle += 0.3) {
    const double s3 = std::cos(angle) / std::numbers::sqrt2;
    const auto probe =
        probe_direction(*response, ProbeKind::stress, Eigen::Vector3d(std::sin(angle), s3, s3));
    CHECK(probe.normalised == Approx(prober(angle).normalised).margin(1e-12));
  }
  const Sphere sphere = probe_sphere(*response, ProbeKind::stress, 36);
  CHECK(sphere.unstable());
  CHECK(sphere.regions == 1);
  CHECK(sphere.least.normalised <= probe_circle(prober).least.normalised + 1e-12);
  // The share of a cone about a direction of the axisymmetric plane, symmetric in axes 2 and 3.
  CHECK(sphere.unstable_share > 0.005);
  CHECK(sphere.unstable_share < 0.1);
  const Sphere finer = probe_sphere(*response, ProbeKind::stress, 72);
  CHECK(finer.unstable_share == Approx(sphere.unstable_share).epsilon(0.02));
  CHECK(finer.least.normalised == Approx(sphere.least.normalised).margin(1e-9));
}

TEST_CASE("all six components: at least as unstable as the principal ones") {
  const Sanisand<Tensor> law(s28_general());
  const auto response = response_at<Tensor>(law, 70, 0.62, 1.086);
  const Sphere sphere = probe_sphere(*response, ProbeKind::stress, 24);
  const FreeProbe all = least_of_all_directions(*response, ProbeKind::stress, sphere.least);
  REQUIRE(all.answered);
  CHECK(all.normalised <= sphere.least.normalised + 1e-9);
  const auto rate = response->to_stress(all.direction);
  CHECK(rate.normalised_work() == Approx(all.normalised).margin(1e-12));
}

TEST_CASE("regions are counted across the seam of the azimuth, and few rings are refused") {
  const auto law3 = inl2_tensor();
  const auto response = response_at<Tensor>(law3, 70, 0.9, 1.086);
  const Sphere sphere = probe_sphere(*response, ProbeKind::stress, 36);
  CHECK(sphere.regions == 1);
  CHECK_THROWS_AS(probe_sphere(*response, ProbeKind::stress, 5), std::invalid_argument);
}

TEST_CASE("the unstable share converges: 5 degrees against 1, and a cone within one cell") {
  const auto law3 = inl2_tensor();
  for (const double eta : {0.6, 0.7}) {
    CAPTURE(eta);
    const auto response = response_at<Tensor>(law3, 70, eta, 1.086);
    const Sphere coarse = probe_sphere(*response, ProbeKind::stress, 36);
    const Sphere fine = probe_sphere(*response, ProbeKind::stress, 180);
    CHECK(coarse.unstable_share == Approx(fine.unstable_share).epsilon(0.02));
  }
  // Just unstable: no centre of the coarse cells is, the least direction between them is.
  const auto response = response_at<Tensor>(law3, 70, 0.57, 1.086);
  const Sphere coarse = probe_sphere(*response, ProbeKind::stress, 6);
  REQUIRE(coarse.unstable());
  CHECK(std::ranges::none_of(coarse.probes, [](const auto& p) { return p.normalised < 0; }));
  CHECK(coarse.regions == 1);
}

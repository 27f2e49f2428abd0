// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/probe.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/materials/elastic.hpp"
#include "tests/sim/stability/stability_states.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

constexpr double kPoisson = 0.2, kYoung = 40e6;

template <class Space>
Elastic<Space> elastic() {
  ElasticParameters p;
  p.young_modulus_pa = kYoung;
  p.poisson_ratio = kPoisson;
  p.reference_pressure_pa = 100e3;
  return Elastic<Space>(p);
}

}  // namespace

TEST_CASE("isotropic unloading is at 215.26 degrees, where q does not change and p' falls") {
  CHECK(degrees(kIsotropicUnloading) == Approx(215.2644).margin(1e-4));
  const PlaneVector v = unit_direction(kIsotropicUnloading);
  const Vector<Axisymmetric> stress(v.y(), v.x());
  CHECK(std::abs(deviator_stress<Axisymmetric>(stress)) < 1e-15);
  CHECK(mean_stress<Axisymmetric>(stress) == Approx(-1 / std::sqrt(3.0)));
  CHECK(angle_of(v) == Approx(kIsotropicUnloading));
  CHECK(rendulic(stress) == v);
}

TEST_CASE("axisymmetric stress probes of elasticity: strain and work in closed form") {
  const auto law = elastic<Axisymmetric>();
  const auto prober = make_prober(response_at<Axisymmetric>(law, 100, 0.3, 0.8), ProbeKind::stress);
  for (double angle = 0; angle < 6.28; angle += 0.4) {
    const Probe probe = prober(angle);
    const double s1 = std::sin(angle), s3 = std::cos(angle) / std::numbers::sqrt2;
    const double e1 = (s1 - 2 * kPoisson * s3) / kYoung;
    const double e3 = (s3 - kPoisson * (s1 + s3)) / kYoung;
    REQUIRE(probe.answered);
    CHECK(probe.angle == angle);
    CHECK(probe.stress.y() == Approx(s1).margin(1e-12));
    CHECK(probe.strain.y() == Approx(e1).margin(1e-18));
    CHECK(probe.strain.x() == Approx(std::numbers::sqrt2 * e3).margin(1e-18));
    CHECK(probe.second_order_work == Approx(s1 * e1 + 2 * s3 * e3));
    CHECK(probe.normalised ==
          Approx(probe.second_order_work / std::hypot(e1, std::numbers::sqrt2 * e3)));
  }
}

TEST_CASE("plane-strain probes of elasticity: the strain across stays zero") {
  const auto law = elastic<Tensor>();
  const auto prober = make_prober(response_at<Tensor>(law, 100, 0.3, 0.8), ProbeKind::stress);
  for (double angle = 0; angle < 6.28; angle += 0.4) {
    const Probe probe = prober(angle);
    const double s1 = std::sin(angle), s3 = std::cos(angle);
    const double s2 = kPoisson * (s1 + s3);  // dε₂ = 0
    REQUIRE(probe.answered);
    CHECK(probe.strain.y() == Approx((s1 - kPoisson * (s2 + s3)) / kYoung).margin(1e-18));
    CHECK(probe.strain.x() == Approx((s3 - kPoisson * (s2 + s1)) / kYoung).margin(1e-18));
    CHECK(probe.second_order_work == Approx(probe.stress.dot(probe.strain)));
  }
}

TEST_CASE("a strain probe along a stress probe's answer gives that stress direction back") {
  const auto law = inl2();
  const auto response = response_at<Axisymmetric>(law, 70, 0.5, 1.086);
  const auto stress_prober = make_prober(response, ProbeKind::stress);
  const auto strain_prober = make_prober(response, ProbeKind::strain);
  for (double angle = 0.1; angle < 6.28; angle += 0.5) {
    const Probe probe = stress_prober(angle);
    const Probe back = strain_prober(angle_of(probe.strain));
    REQUIRE(back.answered);
    CHECK((back.stress.normalized() - probe.stress).norm() < 1e-9);
    CHECK(back.normalised == Approx(probe.normalised).margin(1e-9));
  }
}

TEST_CASE("finite probes tend to the rate with the norm, in proportion to it") {
  const auto law = inl2();
  const auto response = response_at<Axisymmetric>(law, 70, 0.6, 1.086);
  const auto rate = make_prober(response, ProbeKind::stress);
  for (const double angle : {0.3, 2.0, 3.9, 5.5}) {
    std::array<double, 3> difference{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double norm = 1000 * std::pow(0.1, static_cast<double>(i));
      const Probe probe =
          make_finite_prober(law, response->state(), ProbeKind::stress, norm)(angle);
      REQUIRE(probe.answered);
      CHECK(probe.stress.norm() == Approx(norm));
      difference[i] = (probe.strain / norm - rate(angle).strain).norm() / rate(angle).strain.norm();
    }
    // Where it falls, |η| has gone a part of 0.2 m, over which the law becomes elastic.
    const Vector<Axisymmetric> direction(std::sin(angle), std::cos(angle));
    const double rise =
        deviator_stress<Axisymmetric>(direction) - 0.6 * mean_stress<Axisymmetric>(direction);
    if (rise < 0) {
      CHECK(difference[1] < 0.6 * difference[0]);
      CHECK(difference[2] < 0.01);
      continue;
    }
    CHECK(difference[0] < 0.2);
    CHECK(difference[1] / difference[0] == Approx(0.1).epsilon(0.25));
    CHECK(difference[2] / difference[1] == Approx(0.1).epsilon(0.1));
  }
}

TEST_CASE("finite probes of six components: plane strain, elasticity is exact at any norm") {
  const auto law = elastic<Tensor>();
  const auto response = response_at<Tensor>(law, 100, 0.3, 0.8);
  const auto rate = make_prober(response, ProbeKind::strain);
  const auto finite = make_finite_prober(law, response->state(), ProbeKind::strain, 1e-4);
  for (double angle = 0; angle < 6.28; angle += 0.7)
    CHECK((finite(angle).stress - 1e-4 * rate(angle).stress).norm() <
          1e-9 * finite(angle).stress.norm());
}

TEST_CASE("a finite probe that does not arrive is not answered") {
  const auto law = inl2();
  const auto response = response_at<Axisymmetric>(law, 70, 1.2, 1.086);
  const auto prober = make_finite_prober(law, response->state(), ProbeKind::stress, 50e3);
  CHECK_FALSE(prober(std::numbers::pi / 2).answered);
  CHECK(prober(std::numbers::pi / 2).normalised == 0);
}

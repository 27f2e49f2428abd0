// SPDX-License-Identifier: GPL-3.0-or-later
// Elasticity from an energy: against differences of the energy, and over closed cycles of stress
// that the point driver integrates.
#include "sim/materials/hyperelastic.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/materials/cam_clay.hpp"
#include "sim/materials/drucker_prager.hpp"
#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;
using Control = MixedControl<Axisymmetric>;
using State = PointState<Axisymmetric>;

namespace {

constexpr double kYoung = 60e6, kPoisson = 0.2, kReference = 100e3;
constexpr double kReferenceBulk = kYoung / (3 * (1 - 2 * kPoisson)),
                 kReferenceShear = kYoung / (2 * (1 + kPoisson));

ElasticParameters power(double exponent, double hyperelastic) {
  return {kYoung, kPoisson, exponent, kReference, hyperelastic};
}
CamClayParameters overconsolidated(double hyperelastic) {
  return {0.1, 0.01, 1.2, 0.3, 20, hyperelastic};
}

/// The complementary energy in p and q, over K_ref: closed form of the paper, not of the law.
long double energy(long double p, long double q, long double n) {
  const long double b = kReferenceBulk / (3 * kReferenceShear);  // p_o² = p² + (1 − n) b q²
  if (n == 1) return p * std::log(p / kReference) - p + b * q * q / (2 * p);
  const long double p_o = std::sqrt(p * p + (1 - n) * b * q * q);
  return std::pow(p_o, 2 - n) * std::pow(kReference, n) / ((1 - n) * (2 - n)) -
         p * kReference / (1 - n);
}

long double energy_of(const Vector<Tensor>& stress, double n) {
  const long double scale = n == 1 ? kReference : 1;
  return scale *
         energy(mean_stress<Tensor>(stress), deviator<Tensor>(stress).norm() * std::sqrt(1.5L), n) /
         kReferenceBulk;
}

/// ∂²Ψ/∂σ∂σ by central differences.
Matrix<Tensor> compliance_by_differences(const Vector<Tensor>& stress, double n) {
  const double h = 2e-3 * mean_stress<Tensor>(stress);
  Matrix<Tensor> c;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const Vector<Tensor> a = h * Vector<Tensor>::Unit(i), b = h * Vector<Tensor>::Unit(j);
      c(i, j) = static_cast<double>((energy_of(stress + a + b, n) - energy_of(stress + a - b, n) -
                                     energy_of(stress - a + b, n) + energy_of(stress - a - b, n)) /
                                    (4.0L * h * h));
    }
  return c;
}

struct Cycle {
  double work = 0;       ///< ∮ σ:dε
  double of_solids = 0;  ///< ∮ (1 + e) σ:dε
  double exchanged = 0;  ///< ∮ |σ:dε|
  Vector<Axisymmetric> strain = Vector<Axisymmetric>::Zero();
};

/// (p₁, q₁) → (p₂, q₁) → (p₂, q₂) → (p₁, q₂) → (p₁, q₁), work by Simpson's rule over steps.
Cycle rectangle(const Law<Axisymmetric>& law, State state, double dp, double dq) {
  constexpr int kSteps = 200;
  Cycle cycle;
  for (const auto& [p, q] : {std::pair{dp, 0.0}, {0.0, dq}, {-dp, 0.0}, {0.0, -dq}})
    for (int i = 0; i < kSteps; ++i) {
      const Control half = Control::stress_path(p / (2 * kSteps), q / (2 * kSteps));
      const auto first = advance_point(law, state, half, {.relative = 1e-11});
      const auto second = advance_point(law, first.state, half, {.relative = 1e-11});
      REQUIRE(second.outcome == StepOutcome::accepted);
      // A parabola of the strain over the step, at equal steps of stress.
      const Vector<Axisymmetric> d1 = first.strain_increment, d2 = second.strain_increment;
      const double work = (state.stress + first.state.stress).dot(d1) / 2 +
                          (first.state.stress + second.state.stress).dot(d2) / 2;
      cycle.work += work;
      cycle.of_solids += (1 + first.state.void_ratio) * work;
      cycle.exchanged += std::abs(work);
      cycle.strain += d1 + d2;
      state = second.state;
    }
  return cycle;
}

State at(const Law<Axisymmetric>& law, double p, double q) {
  return law.start(components(AxisymmetricStress{p + 2 * q / 3, p - q / 3}), 0.8);
}

}  // namespace

TEST_CASE("the stiffness is the inverse of the second derivatives of the energy") {
  test::RandomTensors random;
  for (const double n : {0.3, 0.65, 1.0}) {
    const Elastic<Tensor> law(power(n, 1));
    for (int i = 0; i < 20; ++i) {
      const auto stress = random.stress<Tensor>(random.uniform(30e3, 600e3), 0.8);
      const auto c = test::tangent_of(law.response(law.start(stress, 0.8)), 0);
      CHECK((c - c.transpose()).norm() < 1e-12 * c.norm());
      const Matrix<Tensor> unit = c * compliance_by_differences(stress, n);
      CHECK((unit - Matrix<Tensor>::Identity()).norm() < 2e-4);
    }
  }
}

TEST_CASE("homogeneous of degree n, objective, and K and G of the power law where s = 0") {
  test::RandomTensors random;
  for (const double n : {0.0, 0.5, 1.0}) {
    const Elastic<Tensor> law(power(n, 1));
    const auto tangent = [&law](const Vector<Tensor>& stress) {
      return test::tangent_of(law.response(law.start(stress, 0.8)), 0);
    };
    for (int i = 0; i < 20; ++i) {
      const auto stress = random.stress<Tensor>(100e3, 0.7);
      const auto c = tangent(stress);
      CHECK(tangent(Vector<Tensor>(3.7 * stress)).isApprox(std::pow(3.7, n) * c, 1e-12));
      const Matrix<Tensor> turned = rotation(random.turn());
      CHECK(tangent(Vector<Tensor>(turned * stress))
                .isApprox(turned * c * turned.transpose(), 1e-12));
      CHECK(c.llt().info() == Eigen::Success);
    }
    const auto isotropic_one = isotropic<Tensor>(250e3);
    CHECK(
        tangent(isotropic_one)
            .isApprox(test::tangent_of(
                          Elastic<Tensor>(power(n, 0)).response(law.start(isotropic_one, 0.8)), 0),
                      1e-12));
  }
}

TEST_CASE("a closed cycle of p and q costs nothing with an energy, its closed form without") {
  const double n = 0.65, p1 = 60e3, p2 = 150e3, q1 = 10e3, q2 = 50e3;
  const Elastic<Axisymmetric> potential(power(n, 1)), rates(power(n, 0));
  const Cycle none = rectangle(potential, at(potential, p1, q1), p2 - p1, q2 - q1);
  CHECK(std::abs(none.work) < 1e-6 * none.exchanged);
  CHECK(none.strain.norm() < 1e-10);

  const Cycle gain = rectangle(rates, at(rates, p1, q1), p2 - p1, q2 - q1);
  const auto shear = [n](double p) { return kReferenceShear * std::pow(p / kReference, n); };
  const double closed = (q2 * q2 - q1 * q1) / 6 * (1 / shear(p2) - 1 / shear(p1));
  CHECK(closed < 0);  // work for nothing
  CHECK(gain.work == Approx(closed).epsilon(1e-4));
  CHECK(-gain.work > 0.01 * gain.exchanged);
}

TEST_CASE("overconsolidated Cam-Clay: the same per volume of solids") {
  const double p1 = 60e3, p2 = 150e3, q1 = 10e3, q2 = 50e3;
  const CamClay<Axisymmetric> potential(overconsolidated(1)), rates(overconsolidated(0));
  const Cycle none = rectangle(potential, at(potential, p1, q1), p2 - p1, q2 - q1);
  CHECK(std::abs(none.of_solids) < 2e-6 * none.exchanged);

  const Cycle gain = rectangle(rates, at(rates, p1, q1), p2 - p1, q2 - q1);
  // v = 1 + e falls by κ ln(p₂/p₁), whatever q; G = r v p/κ.
  const double v1 = 1.8, v2 = v1 - 0.01 * std::log(p2 / p1), r = 3 * 0.4 / 2.6 / 0.01;
  const double closed = (q2 * q2 - q1 * q1) / 6 * (1 / (r * p2 * v2) - 1 / (r * p1 * v1));
  CHECK(gain.work == Approx(closed).epsilon(1e-3));
  CHECK(gain.work < 0);
}

TEST_CASE("plastic laws are hyperelastic within their surface if asked to, and Cam-Clay beyond") {
  DruckerPragerParameters par;
  static_cast<ElasticParameters&>(par) = power(0.65, 1);
  par.friction_angle = radians(34);
  const DruckerPrager<Axisymmetric> cone(par);
  const Elastic<Axisymmetric> within(power(0.65, 1));
  const State s = at(cone, 100e3, 60e3);
  CHECK(test::tangent_of(cone.response(s), 0).isApprox(test::tangent_of(within.response(s), 0)));
  // Undrained, p′ grows with shear before yield.
  const auto sheared = advance_point(within, at(within, 100e3, 20e3), Control::strain_path(5e-4));
  CHECK(sheared.state.p() > 100e3 * 1.01);

  // The critical state does not depend on the elasticity.
  CamClayParameters clay = overconsolidated(1);
  clay.overconsolidation_ratio = 1;
  const CamClay<Axisymmetric> material(clay);
  const auto end = advance_point(material, material.isotropic(200e3, 0.8), Control::strain_path(1));
  REQUIRE(end.outcome == StepOutcome::accepted);
  CHECK(end.state.q() / end.state.p() == Approx(1.2).epsilon(1e-4));
}

TEST_CASE("a choice that is neither 0 nor 1 is refused by name") {
  CHECK_THROWS_WITH(Elastic<Tensor>(power(0.65, 0.5)), Catch::Contains("hyperelastic is 0.5"));
  CHECK_THROWS_WITH(CamClay<Tensor>(overconsolidated(0.5)), Catch::Contains("hyperelastic"));
}

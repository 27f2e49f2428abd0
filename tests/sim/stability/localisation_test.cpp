// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/localisation.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "sim/materials/elastic.hpp"
#include "sim/materials/mohr_coulomb.hpp"
#include "tests/sim/materials/random_tensors.hpp"
#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

/// Elastoplastic tangent of one mechanism that loads.
Matrix<Tensor> tangent(const Matrix<Tensor>& c, const Vector<Tensor>& flow,
                       const Vector<Tensor>& normal, double h) {
  return c - c * flow * (c * normal).transpose() / (h + normal.dot(c * flow));
}

/// Rudnicki and Rice's material: friction μ, dilatancy β, deviator (s₁, s₂, s₃)/τ̄ of the state.
struct Frictional {
  double G = 1e7, nu = 0.25, mu = 0, beta = 0;
  Eigen::Vector3d s;

  Matrix<Tensor> elastic() const {
    return isotropic_stiffness<Tensor>(2 * G * (1 + nu) / (3 * (1 - 2 * nu)), G);
  }
  Vector<Tensor> direction(double friction) const {
    Vector<Tensor> v = -friction / 3 * identity<Tensor>();
    v.head<3>() += s / 2;
    return v;
  }
  Localisation at(double h) const {
    return localisation(tangent(elastic(), direction(beta), direction(mu), h), elastic());
  }
  /// Their N, of the intermediate principal deviator with tension positive.
  double N() const { return -s(1); }
  double critical_hardening() const {
    const double sum = N() + (beta + mu) / 3, difference = beta - mu;
    return G * ((1 + nu) / (9 * (1 - nu)) * difference * difference - (1 + nu) / 2 * sum * sum);
  }
  /// tan²θ₀ of the band normal against the axis of the largest compression; below 0: no such band.
  double tan2() const {
    const double xi = (1 + nu) * (beta + mu) / 3 - N() * (1 - nu);
    const double root = std::sqrt(1 - 0.75 * N() * N());
    return (xi + N() / 2 + root) / (-N() / 2 + root - xi);
  }
  /// h at which the least determinant vanishes.
  double found_hardening() const {
    const double size = direction(mu).dot(elastic() * direction(beta));
    double singular = -0.9 * size, regular = 3 * size;
    while (regular - singular > 1e-9 * G) {
      const double middle = (singular + regular) / 2;
      (at(middle).determinant < 0 ? singular : regular) = middle;
    }
    return regular;
  }
};

/// s/τ̄ with |s|² = 2, s₁ ≥ s₂ ≥ s₃, at a Lode angle: 0 axisymmetric compression, 60° extension.
Eigen::Vector3d deviator_at(double lode) {
  const double third = 2 * std::numbers::pi / 3;
  return 2 / std::sqrt(3.0) *
         Eigen::Vector3d(std::cos(lode), std::cos(lode - third), std::cos(lode + third));
}

IncrementalResponse<Tensor> tensor_response(const Law<Tensor>& law, double p_kPa, double eta,
                                            double e) {
  return {law, law.start(as_tensor(state_at(octo(), p_kPa, eta, e).stress), e)};
}

}  // namespace

TEST_CASE("the acoustic tensor of isotropic elasticity") {
  const double K = 2e7, G = 1.2e7;
  RandomTensors random;
  const Matrix<Tensor> c = isotropic_stiffness<Tensor>(K, G);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d n = random.turn().col(0);
    const Eigen::Matrix3d a = acoustic_tensor(c, n);
    CHECK(a.determinant() == Approx((K + 4 * G / 3) * G * G).epsilon(1e-12));
    // (K + G/3) n n + G I
    const Eigen::Matrix3d expected =
        (K + G / 3) * n * n.transpose() + G * Eigen::Matrix3d::Identity();
    CHECK((a - expected).norm() < 1e-12 * expected.norm());
  }
  CHECK(localisation(c, c).determinant == Approx(1).epsilon(1e-12));
  CHECK(localisation(0.5 * c, c).determinant == Approx(0.125).epsilon(1e-12));
}

TEST_CASE("the acoustic tensor of any stiffness is n_j D_ijkl n_l, in turned axes too") {
  RandomTensors random;
  for (int t = 0; t < 50; ++t) {
    Matrix<Tensor> d;
    for (int k = 0; k < 36; ++k) d(k) = random.uniform(-1, 1);
    const Eigen::Matrix3d q = random.turn();
    const Eigen::Vector3d n = random.turn().col(0);
    // Aᵢₖ = eᵢ·σ n with σ = D : sym(e_k ⊗ n).
    const Eigen::Matrix3d a = acoustic_tensor(d, n);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Matrix3d strain =
          (Eigen::Vector3d::Unit(k) * n.transpose() + n * Eigen::RowVector3d::Unit(k)) / 2;
      const Eigen::Vector3d traction = matrix_of(d * components(strain)) * n;
      CHECK((a.col(k) - traction).norm() < 1e-12);
    }
    const Matrix<Tensor> turn = rotation(q);
    const Eigen::Matrix3d turned = acoustic_tensor(turn * d * turn.transpose(), q * n);
    CHECK((turned - q * a * q.transpose()).norm() < 1e-12);
  }
}

TEST_CASE("critical hardening and band of Rudnicki and Rice (1975)") {
  RandomTensors random;
  int inside = 0;
  for (int t = 0; t < 40; ++t) {
    Frictional f;
    f.nu = random.uniform(0, 0.45);
    f.mu = random.uniform(0, 0.9);
    f.beta = random.uniform(-0.2, f.mu);
    f.s = deviator_at(random.uniform(0, std::numbers::pi / 3));
    CAPTURE(f.nu, f.mu, f.beta, f.N());
    if (!(f.tan2() > 0.01) || !(f.tan2() < 100)) continue;
    ++inside;
    const double h = f.found_hardening();
    CHECK(h / f.G == Approx(f.critical_hardening() / f.G).margin(1e-6));
    const Localisation band = f.at(h);
    CHECK(std::abs(band.normal(1)) < 1e-3);
    CHECK(std::tan(band.inclination()) == Approx(std::sqrt(f.tan2())).epsilon(1e-3));
  }
  CHECK(inside > 20);
}

TEST_CASE("von Mises in pure shear localises at the end of hardening, in axisymmetry far beyond") {
  Frictional f;
  f.s = deviator_at(std::numbers::pi / 6);
  CHECK(f.found_hardening() == Approx(0).margin(1e-6 * f.G));
  CHECK(degrees(f.at(0).inclination()) == Approx(45).margin(0.01));
  for (const double lode : {0.0, std::numbers::pi / 3}) {
    f.s = deviator_at(lode);
    CHECK(f.found_hardening() == Approx(-(1 + f.nu) / 6 * f.G).epsilon(1e-5));
  }
}

TEST_CASE("Mohr-Coulomb at yield: Coulomb, Roscoe and the band between them") {
  for (const double psi_deg : {32.0, 10.0, 0.0}) {
    CAPTURE(psi_deg);
    MohrCoulombParameters p;
    p.young_modulus_pa = 2e7;
    p.poisson_ratio = 0.2;
    p.reference_pressure_pa = 1e5;
    p.friction_angle = radians(32);
    p.dilation_angle = radians(psi_deg);
    const MohrCoulomb<Tensor> material(p);
    // On the plane (1, 3) alone.
    const double radial = 50e3, s = std::sin(p.friction_angle), d = std::sin(p.dilation_angle);
    const double axial = radial * (1 + s) / (1 - s);
    const auto state = material.start(
        (Vector<Tensor>() << axial, (axial + radial) / 2, radial, 0, 0, 0).finished(), 0.8);
    const IncrementalResponse<Tensor> response(material, state);
    const auto found = state_localisation(response, ProbePlane::plane_strain);
    REQUIRE(found);
    CHECK(found->kind == ProbeKind::strain);  // at the limit no stress increment loads

    // The least is in the middle in cos 2θ, Arthur's angle 45° + (φ + ψ)/4 but for second order.
    CHECK(std::abs(found->normal(1)) < 1e-3);
    CHECK(std::cos(2 * found->inclination()) == Approx(-(s + d) / 2).margin(1e-4));
    CHECK(degrees(found->inclination()) == Approx(45 + (32 + psi_deg) / 4).margin(0.5));

    // The determinant vanishes at Coulomb's 45° + φ/2 and at Roscoe's 45° + ψ/2.
    const auto rate = response.to_strain((Vector<Tensor>() << 1, 0, -1, 0, 0, 0).finished());
    const Matrix<Tensor> plastic = response.tangent_stiffness(rate).value();
    const double size = std::pow(p.young_modulus_pa, 3);
    for (const double angle_deg : {45 + 16.0, 45 + psi_deg / 2}) {
      const double a = radians(angle_deg);
      const Eigen::Vector3d n(std::cos(a), 0, std::sin(a));
      CHECK(std::abs(acoustic_tensor(plastic, n).determinant()) < 1e-12 * size);
    }
    if (psi_deg == 32)
      CHECK(found->determinant == Approx(0).margin(1e-9));
    else
      CHECK(found->determinant < -1e-3);
  }
}

TEST_CASE("elasticity at a state localises nowhere, and no probe matters") {
  ElasticParameters parameters{.young_modulus_pa = 2e7, .poisson_ratio = 0.2};
  parameters.reference_pressure_pa = 1e5;
  const Elastic<Tensor> material(parameters);
  for (const auto plane : {ProbePlane::axisymmetric, ProbePlane::plane_strain}) {
    const auto found = state_localisation(
        IncrementalResponse<Tensor>(material, material.isotropic(1e5, 0.8)), plane);
    REQUIRE(found);
    CHECK(found->determinant == Approx(1));
  }
}

TEST_CASE("loose sand is unstable before a band can form") {
  const auto material = law<Tensor>(Interpolation::inl2, kInl2);
  const Sanisand<Tensor> base(s28_general());
  for (const Law<Tensor>* law :
       {static_cast<const Law<Tensor>*>(&material), static_cast<const Law<Tensor>*>(&base)})
    for (const auto plane : {ProbePlane::axisymmetric, ProbePlane::plane_strain})
      for (const double eta : {0.3, 0.62}) {
        const auto found = state_localisation(tensor_response(*law, 70, eta, 1.086), plane);
        REQUIRE(found);
        CHECK(found->determinant > 0);
        CHECK(found->determinant < 1);
      }
  CHECK(probe_circle(stress_prober<Axisymmetric>(inl2(), state_at(inl2(), 70, 0.62, 1.086)))
            .unstable());
}

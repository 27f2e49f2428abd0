// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/stability_determinant.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "sim/materials/elastic.hpp"
#include "sim/stability/octolinear_cones.hpp"
#include "tests/sim/stability/first_loss.hpp"
#include "tests/sim/stability/random_compliances.hpp"
#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

double work(const IncrementalResponse<Axisymmetric>& response, const Eigen::Vector2d& stress) {
  return response.to_stress(stress).second_order_work();
}

/// ½ ∂W₂/∂dσ∂dσ by second differences.
Eigen::Matrix2d by_differences(const IncrementalResponse<Axisymmetric>& response, double angle) {
  const Eigen::Vector2d s(std::sin(angle), std::cos(angle));
  const double d = 1e-4;
  Eigen::Matrix2d h;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const Eigen::Vector2d a = d * Eigen::Vector2d::Unit(i), b = d * Eigen::Vector2d::Unit(j);
      h(i, j) = (work(response, s + a + b) - work(response, s + a - b) - work(response, s - a + b) +
                 work(response, s - a - b)) /
                (8 * d * d);
    }
  return h;
}

}  // namespace

TEST_CASE("the relative determinant has the sign of the least eigenvalue") {
  CHECK(relative_determinant(3 * Eigen::Matrix2d::Identity()) == Approx(1));
  CHECK(relative_determinant(-3 * Eigen::Matrix2d::Identity()) == Approx(-1));
  RandomCompliances random;
  for (int i = 0; i < 2000; ++i) {
    Eigen::Matrix2d m;
    for (int k = 0; k < 4; ++k) m(k) = random.uniform(-1, 1);
    const Eigen::Matrix2d s = (m + m.transpose()) / 2;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(s);
    const auto& values = solver.eigenvalues();
    const double expected = values(0) * std::abs(values(1)) / (s.squaredNorm() / 2);
    CHECK(relative_determinant(m) == Approx(expected).margin(1e-12));
    const double alpha = least_direction(m);
    CHECK(alpha >= 0);
    CHECK(alpha <= std::numbers::pi);
    const Eigen::Vector2d v(std::sin(alpha), std::cos(alpha));
    CHECK((s * v - values(0) * v).norm() < 1e-12);
  }
}

TEST_CASE("H is half the second derivative of W2 in every direction, and W2 its quadratic form") {
  for (const auto& [name, law] : stability_laws()) {
    INFO(name);
    const auto response = *response_at(*law, 70, 0.45, 1.086);
    int answered = 0;
    for (double angle = 0.1; angle < 6.28; angle += 0.37) {
      const auto h = half_hessian(response, angle);
      if (!h) continue;
      ++answered;
      const Eigen::Matrix2d differences = by_differences(response, angle);
      CHECK((*h - differences).norm() < 1e-5 * h->norm());
      const Eigen::Vector2d s(std::sin(angle), std::cos(angle));
      CHECK(std::abs(s.dot(*h * s) - work(response, s)) < 1e-9 * h->norm());
    }
    CHECK(answered > 10);
  }
}

TEST_CASE("elasticity's determinant in closed form, in axisymmetry and plane strain") {
  const double E = 2e7, nu = 0.2;
  ElasticParameters parameters{.young_modulus_pa = E, .poisson_ratio = nu};
  parameters.reference_pressure_pa = 1e5;
  const Elastic<Axisymmetric> axisymmetric(parameters);
  const auto found = stability_determinant(
      IncrementalResponse<Axisymmetric>(axisymmetric, axisymmetric.isotropic(1e5, 0.8)));
  REQUIRE(found);
  // Eigenvalues (1 − 2ν)/E along p and (1 + ν)/E along q.
  const double a = 1 - 2 * nu, b = 1 + nu;
  CHECK(found->value == Approx(2 * a * b / (a * a + b * b)));
  CHECK(std::remainder(found->angle - kIsotropicUnloading, std::numbers::pi) ==
        Approx(0).margin(1e-9));

  const Elastic<Tensor> tensor(parameters);
  const auto flat =
      stability_determinant(IncrementalResponse<Tensor>(tensor, tensor.isotropic(1e5, 0.8)));
  REQUIRE(flat);
  const double c = (1 + nu) * (1 - 2 * nu), d = 1 + nu;
  CHECK(flat->value == Approx(2 * c * d / (c * c + d * d)));
}

TEST_CASE("octolinear's determinant is the closed form of its zones") {
  const auto material = octo();
  for (const double eta : {0.1, 0.3, 0.5, 0.55, 0.6, 0.8}) {
    const auto s = state_at(material, 70, eta, 1.086);
    const auto found = stability_determinant(IncrementalResponse<Axisymmetric>(material, s));
    const auto closed = least_determinant(octolinear_zones(moduli(material, s)));
    REQUIRE(found);
    REQUIRE(closed);
    CHECK(found->value == Approx(*closed).epsilon(1e-9));
  }
}

TEST_CASE("the determinant vanishes where the first probe is unstable, in its direction") {
  for (const auto& [name, law] : stability_laws()) {
    INFO(name);
    const auto least = [&law = law](double eta) {
      return probe_circle(stress_prober<Axisymmetric>(*law, state_at(*law, 70, eta, 1.086))).least;
    };
    const auto by_probing = first_loss([&](double eta) { return least(eta).normalised; }, 0.05, 0.8,
                                       {.steps = 15, .precision = 1e-9});
    const auto by_determinant = first_loss(
        [&law = law](double eta) -> std::optional<double> {
          const auto d = stability_determinant(*response_at(*law, 70, eta, 1.086));
          return d ? std::optional(d->value) : std::nullopt;
        },
        0.05, 0.8, {.steps = 15, .precision = 1e-9});
    REQUIRE(by_probing);
    REQUIRE(by_determinant);
    CHECK(*by_determinant == Approx(*by_probing).margin(1e-7));
    const auto there = stability_determinant(*response_at(*law, 70, *by_determinant, 1.086));
    CHECK(std::remainder(there->angle - least(*by_probing).angle, 2 * std::numbers::pi) ==
          Approx(0).margin(1e-3));
  }
}

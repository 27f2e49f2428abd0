// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/proportional_control.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "tests/sim/materials/interpolated_laws.hpp"
#include "tests/sim/stability/random_compliances.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

constexpr int kTrials = 5000;

/// Of round-off: `size` is that of the terms that were subtracted.
bool same(double a, double b, double size) { return std::abs(a - b) <= 2e-13 * size; }

/// Eqs. (34) to (41) of moduli against those of the compliance they make, at one R.
template <class Moduli>
void check_identities(const Moduli& m, double e1, double e3, double R) {
  const PlaneCompliance c = plane_compliance(m);
  const Quadratic of_moduli = control_quadratic(m), of_matrix = control_quadratic(c);
  CHECK(of_matrix.a * e1 * e3 == Approx(of_moduli.a).epsilon(1e-12));
  CHECK(same(of_matrix.b * e1 * e3, of_moduli.b, 10 * (e1 + e3)));
  CHECK(of_matrix.c * e1 * e3 == Approx(of_moduli.c).epsilon(1e-12));

  const Eigen::Matrix2d control = control_matrix(m, R);
  const Eigen::Matrix2d same_control = control_matrix(c, R);
  for (int i = 0; i < 4; ++i)
    CHECK(control(i) == Approx(same_control(i)).epsilon(1e-9).margin(1e-9 * std::abs(control(i))));
  const double products =
      std::abs(control(0, 0) * control(1, 1)) + std::abs(control(0, 1) * control(1, 0));
  CHECK(same(control.determinant(), control_determinant(c, R), 100 * products));
  CHECK(failure_rule(m, R) == Approx(failure_rule(c, R)).epsilon(1e-9));
}

}  // namespace

TEST_CASE("Eq. 36: the reduced discriminant of (34) is −2 E1² E3² det Qs") {
  RandomCompliances random;
  for (int i = 0; i < kTrials; ++i) {
    const AxisymmetricModuli m = random.axisymmetric();
    const double e = m.e1_pa * m.e3_pa, R = random.uniform(0.1, 3);
    const Quadratic f = control_quadratic(m);
    const PlaneCompliance q = plane_compliance(m);
    CHECK(same(f.reduced_discriminant(), -2 * e * e * q.symmetric_determinant(),
               f.b * f.b / 4 + std::abs(f.a * f.c)));
    CHECK(f.roots().empty() == (q.symmetric_determinant() > 0));
    check_identities(m, m.e1_pa, m.e3_pa, R);
  }
}

TEST_CASE("Eq. 37: the discriminant of (35) is −4 E1² E3² det Ps") {
  RandomCompliances random;
  for (int i = 0; i < kTrials; ++i) {
    const PrincipalModuli m = principal_moduli(random.principal());
    const double e = m.e_pa(0) * m.e_pa(2), R = random.uniform(0.1, 3);
    const Quadratic f = control_quadratic(m);
    const PlaneCompliance p = plane_compliance(m);
    CHECK(same(f.discriminant(), -4 * e * e * p.symmetric_determinant(),
               f.b * f.b + 4 * std::abs(f.a * f.c)));
    check_identities(m, m.e_pa(0), m.e_pa(2), R);
  }
}

TEST_CASE("at a root the control matrix is singular and the failure rule its null vector") {
  RandomCompliances random;
  int roots = 0;
  for (int i = 0; i < kTrials; ++i) {
    const PrincipalModuli m = principal_moduli(random.principal());
    for (const PlaneCompliance& c :
         {plane_compliance(m), plane_compliance(random.axisymmetric())}) {
      for (const double R : control_quadratic(c).roots()) {
        if (std::abs(R) < 1e-3 || std::abs(R) > 1e3) continue;
        ++roots;
        // The increment dσ₁ = dσ₃/R and what the compliance answers to it.
        const Eigen::Vector2d stress(1, c.weight() * R), strain = c.matrix * stress;
        const double size = c.matrix.norm() * stress.norm();
        CHECK(std::abs(stress.dot(strain)) < 1e-12 * size * stress.norm());
        // Both controls are nil, and dε₁/dσ₃ is as the rule says.
        CHECK(std::abs(strain(0) + c.weight() * R * strain(1)) < 1e-12 * size * stress.norm());
        CHECK(std::abs(failure_rule(c, R) * R - strain(0)) < 1e-12 * size);
        // The direction is that of probe.hpp, and W₂ vanishes in it.
        const double alpha = failure_angle(c.plane, R);
        CHECK(std::abs(c.work(alpha)) < 1e-12 * c.matrix.norm());
        CHECK(1 / (std::tan(alpha) * c.weight()) == Approx(R).epsilon(1e-12));
      }
    }
  }
  CHECK(roots > kTrials);
}

TEST_CASE("a double root where the determinant of the symmetric part vanishes") {
  RandomCompliances random;
  for (int i = 0; i < kTrials; ++i) {
    AxisymmetricModuli m = random.axisymmetric();
    // The V₃³ that makes Eq. (36) vanish.
    const double sum = m.e3_pa * m.v13 + m.e1_pa * m.v31;
    m.v33 = 1 - sum * sum / (2 * m.e1_pa * m.e3_pa);
    if (1 - m.v33 < 0.01) continue;  // 1 − V₃³ would have few digits left
    const Quadratic f = control_quadratic(m);
    CHECK(std::abs(f.discriminant()) < 1e-12 * f.b * f.b);
    CHECK(f.double_root() == Approx(m.e3_pa / sum).epsilon(1e-9));
    const PlaneCompliance c = plane_compliance(m);
    CHECK(std::abs(c.work(failure_angle(c.plane, f.double_root()))) < 1e-12 * c.matrix.norm());
    // The root is the null vector of Qs.
    const Eigen::Vector2d v(1, c.weight() * f.double_root());
    const Eigen::Vector2d gradient = (c.matrix + c.matrix.transpose()) * v;
    CHECK(gradient.norm() < 1e-11 * c.matrix.norm() * v.norm());
  }
}

TEST_CASE("Eq. 34 of INL2 in zone (−, −) as printed in constitutive.md, section 1.4") {
  const auto material = law<Tensor>(Interpolation::inl2, kInl2);
  const auto s = material.start(as_tensor(state_at(inl2(), 70, 0.55, 1.086).stress), 1.086);
  const auto m = axisymmetric_moduli(
      zone_compliance(std::get<InterpolatedForm<Tensor>>(material.response(s)), {}));
  const auto roots = control_quadratic(m).roots();
  REQUIRE(roots.size() == 2);
  CHECK(roots[0] == Approx(0.2537).margin(6e-5));
  CHECK(roots[1] == Approx(1.3407).margin(6e-5));
  CHECK(control_quadratic(m).reduced_discriminant() / 1e6 == Approx(5.462e8).margin(6e4));
  const double det_per_kpa2 = plane_compliance(m).symmetric_determinant() * 1e6;
  CHECK(det_per_kpa2 == Approx(-3.617e-9).margin(6e-13));
}

TEST_CASE("roots of quadratics that have none, one and an infinite one") {
  CHECK(Quadratic{1, 0, 1}.roots().empty());
  CHECK(Quadratic{1, -2, 1}.roots() == std::vector<double>{1});
  CHECK(Quadratic{0, 2, -1}.roots() == std::vector<double>{0.5});
  CHECK(Quadratic{0, 0, 1}.roots().empty());
  // No cancellation: 1e-9 and 1e9.
  const auto roots = Quadratic{1, -(1e9 + 1e-9), 1}.roots();
  REQUIRE(roots.size() == 2);
  CHECK(roots[0] == Approx(1e-9).epsilon(1e-14));
  const auto opposite = Quadratic{1, 0, -4}.roots();
  REQUIRE(opposite.size() == 2);
  CHECK(opposite[1] == 2);
}

TEST_CASE("the tangent of a tensor law in plane strain is P of Eq. 39") {
  RandomCompliances random;
  for (int i = 0; i < 1000; ++i) {
    const PrincipalCompliance n = random.principal();
    Matrix<Tensor> compliance = Matrix<Tensor>::Identity() * 1e-7;
    compliance.topLeftCorner<3, 3>() = n;
    const auto c = plane_compliance(compliance);
    REQUIRE(c);
    const auto p = plane_strain_compliance(principal_moduli(n));
    CHECK((c->matrix - p).norm() < 1e-12 * (p.norm() + n.norm()));
  }
  CHECK_FALSE(plane_compliance(Matrix<Tensor>(Matrix<Tensor>::Zero())));
}

TEST_CASE("elasticity loses control under no R") {
  const double K = 2e7, G = 1e7;
  const auto c =
      plane_compliance(Matrix<Axisymmetric>(isotropic_stiffness<Axisymmetric>(K, G).inverse()));
  CHECK(control_quadratic(c).roots().empty());
  for (double R = -3; R <= 3; R += 0.1) CHECK(control_determinant(c, R) > 0);
}

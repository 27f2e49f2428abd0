// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/zone_moduli.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "tests/sim/materials/interpolated_laws.hpp"
#include "tests/sim/stability/random_compliances.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEST_CASE("moduli of INL2 in zone (−, −, −) as printed in constitutive.md, section 1.4") {
  const auto material = law<Tensor>(Interpolation::inl2, kInl2);
  const auto s = material.start(as_tensor(state_at(inl2(), 70, 0.55, 1.086).stress), 1.086);
  const auto form = std::get<InterpolatedForm<Tensor>>(material.response(s));

  const auto m = axisymmetric_moduli(zone_compliance(form, {}));
  CHECK(m.e1_pa / 1e3 == Approx(18791.9).margin(0.06));
  CHECK(m.e3_pa / 1e3 == Approx(14622.6).margin(0.06));
  CHECK(m.v13 == Approx(0.1000).margin(6e-5));
  CHECK(m.v31 == Approx(1.7462).margin(6e-5));
  CHECK(m.v33 == Approx(-0.1441).margin(6e-5));

  // What the axisymmetric form of the law says of the same zone is Eq. (38) of these moduli.
  const auto q = zone_compliance(moduli(inl2(), state_at(inl2(), 70, 0.55, 1.086)), {});
  CHECK((q - axisymmetric_compliance(m)).norm() < 1e-12 * q.norm());
}

TEST_CASE("a zone's columns are those of loading and unloading") {
  InterpolatedForm<Tensor> form;
  form.plus.setConstant(1);
  form.minus.setConstant(-1);
  const auto n = zone_compliance(form, {{true, false, true}});
  CHECK(n.row(1) == Eigen::RowVector3d(1, -1, 1));

  InterpolatedForm<Axisymmetric> triaxial;
  triaxial.plus.setConstant(1);
  triaxial.minus.setConstant(-1);
  CHECK(zone_compliance(triaxial, {{false, true, true}}).row(0) == Eigen::RowVector2d(-1, 1));
}

TEST_CASE("moduli and compliances say the same") {
  RandomCompliances random;
  for (int i = 0; i < 1000; ++i) {
    const PrincipalCompliance n = random.principal();
    const PrincipalModuli m = principal_moduli(n);
    CHECK((principal_compliance(m) - n).norm() < 1e-14 * n.norm());

    // P, with dσ₂ eliminated by dε₂ = 0.
    Eigen::Matrix2d p;
    for (int r : {0, 1})
      for (int c : {0, 1}) p(r, c) = n(2 * r, 2 * c) - n(2 * r, 1) * n(1, 2 * c) / n(1, 1);
    CHECK((plane_strain_compliance(m) - p).norm() < 1e-13 * (p.norm() + n.norm()));
  }
}

TEST_CASE("Q holds E3 and V33 as their quotient only") {
  RandomCompliances random;
  for (int i = 0; i < 1000; ++i) {
    const AxisymmetricModuli m = random.axisymmetric();
    const Matrix<Axisymmetric> q = axisymmetric_compliance(m);
    const AxisymmetricModuli held = axisymmetric_moduli(q);
    CHECK(held.e1_pa == Approx(m.e1_pa).epsilon(1e-13));
    CHECK(held.v13 == Approx(m.v13).epsilon(1e-13));
    CHECK(held.e3_pa == Approx(m.e3_pa / (1 - m.v33)).epsilon(1e-13));
    CHECK(held.v31 == Approx(m.v31 / (1 - m.v33)).epsilon(1e-13));
    CHECK((axisymmetric_compliance(held) - q).norm() < 1e-14 * q.norm());
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/zone_moduli.hpp"

namespace triax::sim {

ZoneSigns zone_of(const Vector<Axisymmetric>& stress) {
  return {{stress(0) > 0, stress(1) > 0, stress(1) > 0}};
}

ZoneSigns zone_of(const Vector<Tensor>& stress) {
  return {{stress(0) > 0, stress(1) > 0, stress(2) > 0}};
}

PrincipalCompliance zone_compliance(const InterpolatedForm<Tensor>& form, const ZoneSigns& zone) {
  PrincipalCompliance n;
  for (int j = 0; j < 3; ++j)
    n.col(j) =
        (zone.loading[static_cast<std::size_t>(j)] ? form.plus : form.minus).col(j).head<3>();
  return n;
}

Matrix<Axisymmetric> zone_compliance(const InterpolatedForm<Axisymmetric>& form,
                                     const ZoneSigns& zone) {
  Matrix<Axisymmetric> q;
  q << (zone.loading[0] ? form.plus : form.minus).col(0),
      (zone.loading[2] ? form.plus : form.minus).col(1);
  return q;
}

PrincipalModuli principal_moduli(const PrincipalCompliance& n) {
  const Eigen::Vector3d e = n.diagonal().cwiseInverse();
  return {e, -n * e.asDiagonal()};
}

PrincipalCompliance principal_compliance(const PrincipalModuli& moduli) {
  return -moduli.v * moduli.e_pa.cwiseInverse().asDiagonal();
}

AxisymmetricModuli axisymmetric_moduli(const PrincipalCompliance& n) {
  const PrincipalModuli m = principal_moduli(n);
  return {m.e_pa(0), m.e_pa(2), m.v(2, 0), m.v(0, 2), m.v(1, 2)};
}

AxisymmetricModuli axisymmetric_moduli(const Matrix<Axisymmetric>& q) {
  const double e1 = 1 / q(0, 0), e3 = 1 / q(1, 1);
  return {e1, e3, -q(1, 0) * e1 / std::numbers::sqrt2, -q(0, 1) * e3 / std::numbers::sqrt2, 0};
}

Matrix<Axisymmetric> axisymmetric_compliance(const AxisymmetricModuli& m) {
  Matrix<Axisymmetric> q;
  q << 1 / m.e1_pa, -std::numbers::sqrt2 * m.v31 / m.e3_pa,  //
      -std::numbers::sqrt2 * m.v13 / m.e1_pa, (1 - m.v33) / m.e3_pa;
  return q;
}

Eigen::Matrix2d plane_strain_compliance(const PrincipalModuli& m) {
  const auto v = [&m](int j, int i) { return m.v(i - 1, j - 1); };
  const double e1 = m.e_pa(0), e3 = m.e_pa(2);
  Eigen::Matrix2d p;
  p << (1 - v(1, 2) * v(2, 1)) / e1, -(v(3, 1) + v(3, 2) * v(2, 1)) / e3,  //
      -(v(1, 3) + v(1, 2) * v(2, 3)) / e1, (1 - v(2, 3) * v(3, 2)) / e3;
  return p;
}

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/proportional_control.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace triax::sim {

double PlaneCompliance::symmetric_determinant() const {
  const double coupling = (matrix(0, 1) + matrix(1, 0)) / 2;
  return matrix(0, 0) * matrix(1, 1) - coupling * coupling;
}

double PlaneCompliance::work(double angle) const {
  const Eigen::Vector2d v(std::sin(angle), std::cos(angle));
  return v.dot(matrix * v);
}

PlaneCompliance plane_compliance(const AxisymmetricModuli& moduli) {
  return {ProbePlane::axisymmetric, axisymmetric_compliance(moduli)};
}

PlaneCompliance plane_compliance(const PrincipalModuli& moduli) {
  return {ProbePlane::plane_strain, plane_strain_compliance(moduli)};
}

PlaneCompliance plane_compliance(const Matrix<Axisymmetric>& compliance) {
  return {ProbePlane::axisymmetric, compliance};
}

std::optional<PlaneCompliance> plane_compliance(const Matrix<Tensor>& compliance) {
  constexpr std::array<int, 2> kFree{0, 2};
  constexpr std::array<int, 4> kFixed{1, 3, 4, 5};
  const Eigen::FullPivLU<Eigen::Matrix4d> held(compliance(kFixed, kFixed));
  if (!compliance.allFinite() || !held.isInvertible()) return std::nullopt;
  const Eigen::Matrix<double, 4, 2> stresses = held.solve(compliance(kFixed, kFree));
  return PlaneCompliance{ProbePlane::plane_strain,
                         compliance(kFree, kFree) - compliance(kFree, kFixed) * stresses};
}

std::vector<double> Quadratic::roots() const {
  if (a == 0) return b == 0 ? std::vector<double>{} : std::vector<double>{-c / b};
  const double d = discriminant();
  if (d < 0) return {};
  if (d == 0) return {double_root()};
  // The sum of like signs, so that no root suffers from cancellation.
  const double sum = -(b + std::copysign(std::sqrt(d), b)) / 2;
  std::vector<double> both{sum / a, c / sum};
  std::ranges::sort(both);
  return both;
}

Quadratic control_quadratic(const PlaneCompliance& compliance) {
  const Eigen::Matrix2d& m = compliance.matrix;
  const double c = compliance.weight();
  return {c * c * m(1, 1), c * (m(0, 1) + m(1, 0)), m(0, 0)};
}

Quadratic control_quadratic(const AxisymmetricModuli& m) {
  return {2 * m.e1_pa * (1 - m.v33), -2 * (m.e3_pa * m.v13 + m.e1_pa * m.v31), m.e3_pa};
}

Quadratic control_quadratic(const PrincipalModuli& m) {
  const auto v = [&m](int j, int i) { return m.v(i - 1, j - 1); };
  const double e1 = m.e_pa(0), e3 = m.e_pa(2);
  return {e1 * (1 - v(2, 3) * v(3, 2)),
          -(e3 * (v(1, 3) + v(1, 2) * v(2, 3)) + e1 * (v(3, 1) + v(3, 2) * v(2, 1))),
          e3 * (1 - v(1, 2) * v(2, 1))};
}

Eigen::Matrix2d control_matrix(const PlaneCompliance& compliance, double R) {
  const Eigen::Matrix2d& m = compliance.matrix;
  const double r = compliance.weight() * R;
  Eigen::Matrix2d control;
  control << 1, -r * m(0, 1) - m(0, 0),  //
      m(0, 0) + r * m(1, 0), r * r * m.determinant();
  return control / m(0, 0);
}

Eigen::Matrix2d control_matrix(const AxisymmetricModuli& m, double R) {
  Eigen::Matrix2d control;
  control << m.e1_pa, 2 * R * m.e1_pa * m.v31 / m.e3_pa - 1,  //
      1 - 2 * R * m.v13, 2 * R * R * (1 - m.v33 - 2 * m.v13 * m.v31) / m.e3_pa;
  return control;
}

Eigen::Matrix2d control_matrix(const PrincipalModuli& m, double R) {
  const auto v = [&m](int j, int i) { return m.v(i - 1, j - 1); };
  const double e1 = m.e_pa(0), e3 = m.e_pa(2), held = 1 - v(1, 2) * v(2, 1);
  const double d = held - v(1, 3) * v(3, 1) - v(2, 3) * v(3, 2) - v(1, 2) * v(2, 3) * v(3, 1) -
                   v(2, 1) * v(1, 3) * v(3, 2);
  Eigen::Matrix2d control;
  control << e1 / held, e1 * (v(3, 1) + v(3, 2) * v(2, 1)) * R / (e3 * held) - 1,  //
      1 - (v(1, 3) + v(1, 2) * v(2, 3)) * R / held, d * R * R / (e3 * held);
  return control;
}

double control_determinant(const PlaneCompliance& compliance, double R) {
  return control_quadratic(compliance)(R) / compliance.matrix(0, 0);
}

double failure_rule(const PlaneCompliance& compliance, double R) {
  return compliance.matrix(0, 0) / R + compliance.weight() * compliance.matrix(0, 1);
}

double failure_rule(const AxisymmetricModuli& m, double R) {
  return (1 / R - 2 * m.e1_pa / m.e3_pa * m.v31) / m.e1_pa;
}

double failure_rule(const PrincipalModuli& m, double R) {
  const auto v = [&m](int j, int i) { return m.v(i - 1, j - 1); };
  return ((1 - v(1, 2) * v(2, 1)) / R - m.e_pa(0) / m.e_pa(2) * (v(3, 1) + v(3, 2) * v(2, 1))) /
         m.e_pa(0);
}

double failure_angle(ProbePlane plane, double R) {
  return angle_of({PlaneCompliance{plane, {}}.weight() * R, 1});
}

}  // namespace triax::sim

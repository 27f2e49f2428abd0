// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/secant_stiffness.hpp"

namespace triax::sim {

Matrix<Axisymmetric> corrected(const Matrix<Axisymmetric>& stiffness,
                               const Vector<Axisymmetric>& strain,
                               const Vector<Axisymmetric>& stress) {
  return stiffness + (stress - stiffness * strain) * strain.transpose() / strain.squaredNorm();
}

SecantStiffness SecantStiffness::with(const Vector<Axisymmetric>& strain,
                                      const Vector<Axisymmetric>& stress) const {
  SecantStiffness now = *this;
  now.going_on = corrected(towards(strain), strain, stress);
  now.direction = strain.normalized();
  return now;
}

}  // namespace triax::sim

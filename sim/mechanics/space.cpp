// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/space.hpp"

namespace triax::sim {

using std::numbers::sqrt2;

Eigen::Matrix3d matrix_of(const Vector<Tensor>& a) {
  const double xy = a(3) / sqrt2, xz = a(4) / sqrt2, yz = a(5) / sqrt2;
  Eigen::Matrix3d m;
  m << a(0), xy, xz, xy, a(1), yz, xz, yz, a(2);
  return m;
}

Vector<Tensor> components(const Eigen::Matrix3d& a) {
  return (Vector<Tensor>() << a(0, 0), a(1, 1), a(2, 2), sqrt2 * a(0, 1), sqrt2 * a(0, 2),
          sqrt2 * a(1, 2))
      .finished();
}

Matrix<Tensor> rotation(const Eigen::Matrix3d& q) {
  Matrix<Tensor> turned;
  for (int i = 0; i < Tensor::kSize; ++i)
    turned.col(i) =
        components(Eigen::Matrix3d(q * matrix_of(Vector<Tensor>::Unit(i)) * q.transpose()));
  return turned;
}

}  // namespace triax::sim

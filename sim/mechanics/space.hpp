// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Symmetric second-order tensors as vectors of orthonormal components, so that a law is written
// once and serves the triaxial specimen and the full tensor alike: a scalar product of vectors is
// the double contraction, a matrix a fourth-order tensor.
//
//   Axisymmetric   (a₁, √2 a₃)                                 axis 1 axial, 2 = 3 radial
//   Tensor         (a₁₁, a₂₂, a₃₃, √2 a₁₂, √2 a₁₃, √2 a₂₃)     Mandel's components
//
// Compression positive, stress in Pa, strain as a plain number.
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::sim {

struct Axisymmetric {
  static constexpr int kSize = 2;
};
struct Tensor {
  static constexpr int kSize = 6;
};

template <class Space>
using Vector = Eigen::Matrix<double, Space::kSize, 1>;
template <class Space>
using Matrix = Eigen::Matrix<double, Space::kSize, Space::kSize>;

/// δ, the unit tensor: a·δ is the trace of a.
template <class Space>
Vector<Space> identity() {
  if constexpr (Space::kSize == 2)
    return {1, std::numbers::sqrt2};
  else
    return (Vector<Space>() << 1, 1, 1, 0, 0, 0).finished();
}

template <class Space>
double trace(const Vector<Space>& a) {
  if constexpr (Space::kSize == 2)
    return a(0) + std::numbers::sqrt2 * a(1);
  else
    return a(0) + a(1) + a(2);
}

/// a − tr(a)/3 δ
template <class Space>
Vector<Space> deviator(Vector<Space> a) {
  const double mean = trace<Space>(a) / 3;
  if constexpr (Space::kSize == 2)
    a -= mean * identity<Space>();
  else
    a.template head<3>().array() -= mean;
  return a;
}

/// The tensor a·a.
template <class Space>
Vector<Space> square(const Vector<Space>& a) {
  if constexpr (Space::kSize == 2) {
    return {a(0) * a(0), a(1) * a(1) / std::numbers::sqrt2};
  } else {
    constexpr double r = 1 / std::numbers::sqrt2;
    const double xy = a(3) * a(3) / 2, xz = a(4) * a(4) / 2, yz = a(5) * a(5) / 2;
    return (Vector<Space>() << a(0) * a(0) + xy + xz, a(1) * a(1) + xy + yz, a(2) * a(2) + xz + yz,
            a(3) * (a(0) + a(1)) + r * a(4) * a(5), a(4) * (a(0) + a(2)) + r * a(3) * a(5),
            a(5) * (a(1) + a(2)) + r * a(3) * a(4))
        .finished();
  }
}

/// p = tr(σ)/3
template <class Space>
double mean_stress(const Vector<Space>& stress) {
  return trace<Space>(stress) / 3;
}

/// q: σ₁ − σ₃ with its sign in axisymmetry, √(3/2)|s| ≥ 0 of a tensor.
template <class Space>
double deviator_stress(const Vector<Space>& stress) {
  if constexpr (Space::kSize == 2)
    return stress(0) - stress(1) / std::numbers::sqrt2;
  else
    return std::sqrt(1.5) * deviator<Space>(stress).norm();
}

/// pδ
template <class Space>
Vector<Space> isotropic(double p) {
  return p * identity<Space>();
}

inline Vector<Axisymmetric> components(const AxisymmetricStress& s) {
  return {s.axial, std::numbers::sqrt2 * s.radial};
}
inline Vector<Axisymmetric> components(const AxisymmetricStrain& e) {
  return {e.axial, std::numbers::sqrt2 * e.radial};
}
inline AxisymmetricStress axisymmetric_stress(const Vector<Axisymmetric>& s) {
  return {s(0), s(1) / std::numbers::sqrt2};
}
inline AxisymmetricStrain axisymmetric_strain(const Vector<Axisymmetric>& e) {
  return {e(0), e(1) / std::numbers::sqrt2};
}

/// The axisymmetric tensor as a full one, axis 1 first.
inline Vector<Tensor> as_tensor(const Vector<Axisymmetric>& a) {
  const double radial = a(1) / std::numbers::sqrt2;
  return (Vector<Tensor>() << a(0), radial, radial, 0, 0, 0).finished();
}

inline Vector<Tensor> as_tensor(const Vector<Tensor>& a) { return a; }

/// The 6 × 6 matrix that turns components when the axes turn by Q: a′ = Q a Qᵗ.
Matrix<Tensor> rotation(const Eigen::Matrix3d& q);

Eigen::Matrix3d matrix_of(const Vector<Tensor>& a);
Vector<Tensor> components(const Eigen::Matrix3d& a);

/// Whether every principal value is above 0: trace, second and third invariant are.
template <class Space>
bool all_compressed(const Vector<Space>& a) {
  if constexpr (Space::kSize == 2) {
    return a(0) > 0 && a(1) > 0;
  } else {
    const double tr = trace<Space>(a);
    return tr > 0 && tr * tr > a.squaredNorm() && matrix_of(a).determinant() > 0;
  }
}

}  // namespace triax::sim

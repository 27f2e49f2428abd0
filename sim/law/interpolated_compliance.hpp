// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The answer of an interpolated form (sim/law/response.hpp) to a direction of stress, and its
// derivatives.
#include <cmath>

#include "sim/law/response.hpp"

namespace triax::sim {

/// Number of principal stresses that a space has of its own.
template <class Space>
inline constexpr int kPrincipalAxes = Space::kSize == 2 ? 2 : 3;

/// dε(dσ) = ½ (N⁺ + N⁻) dσ + ½ (N⁺ − N⁻) w,  w_j = dσ_j²/|dσ| (INL2) or |dσ_j| (octolinear), in
/// 1/Pa. Homogeneous of degree one; dσ must not be zero.
template <class Space>
class InterpolatedCompliance {
 public:
  explicit InterpolatedCompliance(const InterpolatedForm<Space>& form)
      : InterpolatedCompliance(form.plus, form.minus, form.quadratic) {}
  template <class Plus, class Minus>
  InterpolatedCompliance(const Eigen::MatrixBase<Plus>& plus, const Eigen::MatrixBase<Minus>& minus,
                         bool quadratic)
      : mean_(0.5 * (plus + minus)), half_(0.5 * (plus - minus)), quadratic_(quadratic) {}

  /// ½ (N⁺ + N⁻), the linear part.
  const Matrix<Space>& mean() const { return mean_; }

  Vector<Space> strain(const Vector<Space>& stress) const {
    return mean_ * stress + half_ * weighted(stress, stress.norm());
  }
  /// A direction with its strain, and what its tangent shares with that.
  struct Instant {
    Vector<Space> stress, strain;
    double norm = 0;            ///< |dσ|
    Vector<Space> half_weight;  ///< ½ (N⁺ − N⁻) w
  };
  Instant at(const Vector<Space>& stress) const {
    Instant i;
    i.stress = stress;
    i.norm = stress.norm();
    i.half_weight = half_ * weighted(stress, i.norm);
    i.strain = mean_ * stress + i.half_weight;
    return i;
  }
  /// ∂dε/∂dσ; by homogeneity dε = tangent · dσ too.
  Matrix<Space> tangent(const Instant& at) const {
    Matrix<Space> t = mean_;
    for (int j = 0; j < kPrincipalAxes<Space>; ++j)
      t.col(j) +=
          (quadratic_ ? 2 * single(at.stress, j) / at.norm : sign(at.stress(j))) * half_.col(j);
    if (quadratic_) t -= at.half_weight * (at.stress / (at.norm * at.norm)).transpose();
    return t;
  }
  Matrix<Space> tangent(const Vector<Space>& stress) const { return tangent(at(stress)); }
  /// The compliance of Picard's iteration, dε = secant · dσ, whose columns are scaled only.
  Matrix<Space> secant(const Vector<Space>& stress) const {
    const double norm = stress.norm();
    Vector<Space> w = Vector<Space>::Zero();
    for (int j = 0; j < kPrincipalAxes<Space>; ++j)
      w(j) = quadratic_ ? single(stress, j) / norm : sign(stress(j));
    return mean_ + half_ * w.asDiagonal();
  }

 private:
  static double sign(double value) { return value >= 0 ? 1 : -1; }
  static double single(const Vector<Space>& v, int j) {  // dσ_j from its orthonormal component
    return Space::kSize == 2 && j == 1 ? v(j) / std::numbers::sqrt2 : v(j);
  }
  /// The vector that half_ multiplies.
  Vector<Space> weighted(const Vector<Space>& v, double norm) const {
    Vector<Space> w = Vector<Space>::Zero();
    for (int j = 0; j < kPrincipalAxes<Space>; ++j)
      w(j) = quadratic_ ? v(j) * single(v, j) / norm : std::abs(v(j));
    return w;
  }

  Matrix<Space> mean_, half_;
  bool quadratic_;
};

}  // namespace triax::sim

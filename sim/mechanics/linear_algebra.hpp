// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Systems of as many equations as a space has components. Eigen solves them; its decompositions are
// most of what the compiler has to do for sim, so they are compiled here once for each space. But
// for the two equations of axisymmetry, which every increment solves: those are inlined.
#include <Eigen/LU>
#include <optional>

#include "sim/mechanics/space.hpp"

namespace triax::sim {

/// LU with partial pivoting, kept where one matrix meets several right-hand sides.
template <class Space>
class Factors {
 public:
  Factors() = default;
  explicit Factors(const Matrix<Space>& a);
  double determinant() const;
  /// Not finite where the matrix is singular.
  Vector<Space> solve(const Vector<Space>& b) const;

 private:
  Eigen::PartialPivLU<Matrix<Space>> lu_;
};

template <class Space>
Factors<Space>::Factors(const Matrix<Space>& a) : lu_(a) {}
template <class Space>
double Factors<Space>::determinant() const {
  return lu_.determinant();
}
template <class Space>
Vector<Space> Factors<Space>::solve(const Vector<Space>& b) const {
  return lu_.solve(b);
}

/// x of a x = b; not finite where `a` is singular.
template <class Space>
Vector<Space> solve(const Matrix<Space>& a, const Vector<Space>& b) {
  return Factors<Space>(a).solve(b);
}
extern template class Factors<Tensor>;
extern template Vector<Tensor> solve<Tensor>(const Matrix<Tensor>&, const Vector<Tensor>&);

/// The same with full pivoting; nothing where `a` is singular to round-off.
template <class Space>
std::optional<Vector<Space>> solve_regular(const Matrix<Space>& a, const Vector<Space>& b);

/// a⁻¹; not finite where `a` is singular.
template <class Space>
Matrix<Space> inverse(const Matrix<Space>& a);

/// a⁻¹; nothing where `a` is not finite or its reciprocal condition is not above 1e-13.
template <class Space>
std::optional<Matrix<Space>> regular_inverse(const Matrix<Space>& a);

template <class Space>
double determinant(const Matrix<Space>& a);

/// Principal values of a symmetric tensor, the smallest first, and their directions as columns.
struct PrincipalAxes {
  Eigen::Vector3d values;
  Eigen::Matrix3d directions;
};
PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric);

/// Eigenvector of the smallest eigenvalue of a symmetric matrix of any size, of length 1. It
/// allocates: for what is asked once a path, as at a loss of control.
Eigen::VectorXd least_eigenvector(const Eigen::MatrixXd& symmetric);

}  // namespace triax::sim

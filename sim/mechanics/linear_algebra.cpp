// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/linear_algebra.hpp"

#include <Eigen/Eigenvalues>

namespace triax::sim {

template <class Space>
std::optional<Vector<Space>> solve_regular(const Matrix<Space>& a, const Vector<Space>& b) {
  const Eigen::FullPivLU<Matrix<Space>> lu(a);
  if (!lu.isInvertible()) return std::nullopt;
  return lu.solve(b);
}

template <class Space>
Matrix<Space> inverse(const Matrix<Space>& a) {
  return a.inverse();
}

template <class Space>
std::optional<Matrix<Space>> regular_inverse(const Matrix<Space>& a) {
  if (!a.allFinite()) return std::nullopt;
  const Eigen::PartialPivLU<Matrix<Space>> lu(a);
  if (!(lu.rcond() > 1e-13)) return std::nullopt;
  return lu.inverse();
}

template <class Space>
double determinant(const Matrix<Space>& a) {
  return a.determinant();
}

PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd least_eigenvector(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvectors().col(0);
}

template class Factors<Tensor>;
template Vector<Tensor> solve<Tensor>(const Matrix<Tensor>&, const Vector<Tensor>&);
template std::optional<Vector<Axisymmetric>> solve_regular<Axisymmetric>(
    const Matrix<Axisymmetric>&, const Vector<Axisymmetric>&);
template std::optional<Vector<Tensor>> solve_regular<Tensor>(const Matrix<Tensor>&,
                                                             const Vector<Tensor>&);
template Matrix<Axisymmetric> inverse<Axisymmetric>(const Matrix<Axisymmetric>&);
template Matrix<Tensor> inverse<Tensor>(const Matrix<Tensor>&);
template std::optional<Matrix<Axisymmetric>> regular_inverse<Axisymmetric>(
    const Matrix<Axisymmetric>&);
template std::optional<Matrix<Tensor>> regular_inverse<Tensor>(const Matrix<Tensor>&);
template double determinant<Axisymmetric>(const Matrix<Axisymmetric>&);
template double determinant<Tensor>(const Matrix<Tensor>&);

}  // namespace triax::sim

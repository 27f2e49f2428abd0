// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control/control_solver.hpp"

#include <algorithm>

#include "sim/control/interpolated_solver.hpp"
#include "sim/control/stiffness_solver.hpp"
#include "sim/mechanics/linear_algebra.hpp"

namespace triax::sim {

namespace {

bool holds_shear_at_zero(const PreparedControl<Tensor>& c) {
  const auto apart = [](const Matrix<Tensor>& m) {
    return m.topRightCorner<3, 3>().isZero(0) && m.bottomLeftCorner<3, 3>().isZero(0) &&
           m.bottomRightCorner<3, 3>().isDiagonal(0);
  };
  if (!apart(c.stress) || !apart(c.strain) || !c.increment.tail<3>().isZero(0)) return false;
  for (int i = 3; i < 6; ++i)
    if ((c.stress(i, i) != 0) == (c.strain(i, i) != 0)) return false;
  return true;
}

}  // namespace

template <class Space>
PreparedControl<Space>::PreparedControl(const MixedControl<Space>& c, double modulus_pa)
    : stress(c.stress), strain(c.strain), increment(c.increment) {
  for (int row = 0; row < Space::kSize; ++row) {
    const double size =
        stress.row(row).cwiseAbs().maxCoeff() + strain.row(row).cwiseAbs().maxCoeff() / modulus_pa;
    if (size <= 0) continue;
    stress.row(row) /= size;
    strain.row(row) /= size;
    increment(row) /= size;
  }
  strain_driven = stress.isZero(0);
  if constexpr (Space::kSize == 6) principal = holds_shear_at_zero(*this);
  if (!strain_driven) return;
  const auto found = solve_regular<Space>(strain, increment);
  determined = found.has_value();
  if (determined) strain_increment = *found;
}

template <class Space>
Vector<Space> left_null_vector(const Matrix<Space>& control_matrix) {
  Vector<Space> scale;
  for (int row = 0; row < Space::kSize; ++row)
    scale(row) = 1 / std::max(control_matrix.row(row).norm(), 1e-300);
  const Matrix<Space> scaled = scale.asDiagonal() * control_matrix;
  return scale.cwiseProduct(Vector<Space>(least_eigenvector(scaled * scaled.transpose())));
}

template <class Space>
int row_that_limits(const Vector<Space>& null_vector, const Vector<Space>& increment) {
  Vector<Space> share = null_vector.cwiseProduct(increment).cwiseAbs();
  // A row that asks for nothing can be held while another asks for something.
  if (share.isZero(0)) share = increment.cwiseAbs();
  if (share.isZero(0)) share = null_vector.cwiseAbs();
  Eigen::Index row = 0;
  share.maxCoeff(&row);
  return static_cast<int>(row);
}

template <class Space>
PointRate<Space> solve_control(const Response<Space>& response,
                               const PreparedControl<Space>& control, const Branch& branch,
                               const Vector<Space>& guess) {
  if (const auto* form = std::get_if<StiffnessForm<Space>>(&response))
    return solve_stiffness(*form, control, branch);
  return solve_interpolated(std::get<InterpolatedForm<Space>>(response), control, guess);
}

template struct PreparedControl<Axisymmetric>;
template struct PreparedControl<Tensor>;
template Vector<Axisymmetric> left_null_vector<Axisymmetric>(const Matrix<Axisymmetric>&);
template Vector<Tensor> left_null_vector<Tensor>(const Matrix<Tensor>&);
template int row_that_limits<Axisymmetric>(const Vector<Axisymmetric>&,
                                           const Vector<Axisymmetric>&);
template int row_that_limits<Tensor>(const Vector<Tensor>&, const Vector<Tensor>&);
template PointRate<Axisymmetric> solve_control(const Response<Axisymmetric>&,
                                               const PreparedControl<Axisymmetric>&, const Branch&,
                                               const Vector<Axisymmetric>&);
template PointRate<Tensor> solve_control(const Response<Tensor>&, const PreparedControl<Tensor>&,
                                         const Branch&, const Vector<Tensor>&);

}  // namespace triax::sim

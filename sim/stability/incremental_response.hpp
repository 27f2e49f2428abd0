// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "sim/control/control_solver.hpp"
#include "sim/law/interpolated_compliance.hpp"

namespace triax::sim {

/// PointRate::limiting_variable of a direction that the law refuses (Law::refusal) or, a foreign
/// law, fails in: not controllable, but no limit of control either.
inline constexpr int kRefused = -2;

/// What a law answers at one state, dε = M(dσ) dσ of Eq. (24), made ready for very many directions:
/// the law is asked once, a direction costs a few operations.
///
/// The memory stays that of the state: a reversal that an increment would be is noted by the law
/// after it. Directions are those of a rate; a law that integrates itself (a UMAT) is asked for a
/// small increment each time. What a law cannot follow is not controllable: beyond its limit, and
/// directions that it refuses. The law must outlive this.
template <class Space>
class IncrementalResponse {
 public:
  /// Pre-condition: law.objection(state) is empty.
  IncrementalResponse(const Law<Space>& law, const PointState<Space>& state);

  const PointState<Space>& state() const { return state_; }
  const Law<Space>& law() const { return law_; }
  /// What the law said, and which of its mechanisms may load.
  const Response<Space>& response() const { return response_; }
  const Branch& branch() const { return branch_; }

  /// Whether the answer is linear within zones of directions: elasticity, elastoplasticity and
  /// octolinear, but not INL2, hypoplasticity and laws that integrate themselves.
  bool piecewise_linear() const;

  /// The rate that this stress increment brings.
  PointRate<Space> to_stress(const Vector<Space>& stress) const;
  /// The rate that this strain increment brings.
  PointRate<Space> to_strain(const Vector<Space>& strain) const;
  /// The rate under any mixed control.
  PointRate<Space> to(const MixedControl<Space>& control) const;

  /// Tangent stiffness ∂dσ/∂dε (Pa) around a rate that was found here: of the mechanisms that load,
  /// of the zone, or C − N dεᵗ/|dε|. By homogeneity dσ = T dε. Empty where there is none: an
  /// interpolated form whose tangent compliance is singular.
  std::optional<Matrix<Space>> tangent_stiffness(const PointRate<Space>& rate) const;
  /// ∂dε/∂dσ (1/Pa), likewise; empty at the limit, where the tangent stiffness is singular.
  std::optional<Matrix<Space>> tangent_compliance(const PointRate<Space>& rate) const;

 private:
  PointRate<Space> accepted(PointRate<Space> rate) const;
  PointRate<Space> solve(const PreparedControl<Space>& control) const;
  Matrix<Space> finite_tangent(const PointRate<Space>& rate) const;

  const Law<Space>& law_;
  PointState<Space> state_;
  Response<Space> response_;
  std::optional<InterpolatedCompliance<Space>> compliance_;  // interpolated form only
  double modulus_ = 1;                                       // size of the stiffness, Pa
  Branch branch_;
};

extern template class IncrementalResponse<Axisymmetric>;
extern template class IncrementalResponse<Tensor>;

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Solves S dσ + E dε = dy with the response of a law.
//
// Stiffness form. With A = S C + E, x = A⁻¹ dy, g_k = A⁻¹ S c_k and b = A⁻¹ S N,
//
//   dε = x + Σ g_k λ_k + b |dε|
//
// Mechanisms: the loading ones solve Σ_j M_kj λ_j = m_k·x, M_kj = H_kj − m_k·g_j; the set of them
// is the one that is consistent, and det M/det H = det(S Cᵉᵖ + E)/det A is positive while the
// conditions can be met. Hypoplasticity: |dε| is the smallest root ≥ 0 of
// (1 − b·b) X² − 2 x·b X − x·x = 0, and 1 − b·dε/|dε| = det(S T + E)/det A.
//
// Interpolated form: Newton's method on (S + E C(dσ)) dσ = dy, C the secant compliance, started
// from the stress increment before. Of a tensor the first three components are solved alone where
// neither N⁺ and N⁻ nor the conditions couple shear with anything and shear is held at zero.
//
// Where the determinant vanishes the conditions cannot be met (loss of control in Nova's sense).
// The limiting variable is then the row with the largest |w_i dy_i|, w the left null vector: the
// conditions could be met only if w·dy were zero (Fredholm), and that row contributes most. For a
// mechanism w = A⁻ᵗ m, for hypoplasticity A⁻ᵗ dε/|dε|: also where the determinant has jumped below
// zero.
#include <optional>

#include "sim/control/mixed_control.hpp"
#include "sim/law/law.hpp"

namespace triax::sim {

/// A control made ready for many solutions: rows scaled, pure strain control solved beforehand.
template <class Space>
struct PreparedControl {
  Matrix<Space> stress, strain;
  Vector<Space> increment;
  bool strain_driven = false;  ///< no stress enters
  /// Of a tensor: rows 3 to 5 hold one shear component each at zero, in stress or strain, and rows
  /// 0 to 2 are without shear.
  bool principal = false;
  bool determined = true;          ///< strain driven only: the rows are independent
  Vector<Space> strain_increment;  ///< strain driven only: dε

  /// `modulus_pa` scales strain conditions against those on stress.
  PreparedControl(const MixedControl<Space>& control, double modulus_pa);
};

/// Left vector of the smallest singular value of a (nearly) singular control matrix, which a step
/// may have gone past.
template <class Space>
Vector<Space> left_null_vector(const Matrix<Space>& control_matrix);
/// Row of the control that cannot be held, from the left null vector of the singular control
/// matrix.
template <class Space>
int row_that_limits(const Vector<Space>& null_vector, const Vector<Space>& increment);

/// Which mechanisms may load: those on yield; with `forced` exactly those in it do.
struct Branch {
  unsigned on_yield = 0;
  std::optional<unsigned> forced;
};

/// `guess` is the stress increment at a neighbouring instant (interpolated form), or zero.
/// With a forced branch the result is what that branch gives, consistent or not; see `consistent`.
template <class Space>
PointRate<Space> solve_control(const Response<Space>& response,
                               const PreparedControl<Space>& control, const Branch& branch,
                               const Vector<Space>& guess);

/// Whether a rate on a forced branch has no negative multiplier.
template <class Space>
bool consistent(const PointRate<Space>& rate) {
  for (unsigned k = 0; k < kMostMechanisms; ++k)
    if ((rate.active >> k & 1U) && rate.multiplier[k] < 0) return false;
  return true;
}

}  // namespace triax::sim

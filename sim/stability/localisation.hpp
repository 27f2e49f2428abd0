// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Localisation criterion of Rudnicki and Rice (1975), Rice (1976): a band with normal n can form
// where its acoustic tensor is singular,
//
//   A_ik(n) = n_j D_ijkl n_l,   det A(n) = 0
//
// D the tangent stiffness. In Mandel's components A = Bᵗ D B with B a = sym(a ⊗ n).
//
// An incrementally nonlinear law has no one D. Here every tangent that the law answers with in the
// directions of a plane of probes is taken for a linear comparison solid, the same one inside and
// outside the band, and the worst counts. For elastoplasticity loading on both sides that is Rice's
// condition; for INL2, octolinear and hypoplasticity a real band may choose a tangent of its own on
// either side, so that this criterion is neither an upper nor a lower bound.
//
// INL2 and octolinear are written for principal axes that stay fixed and answer shear along those
// axes elastically. A band inclined to the axes shears along them, so that their localisation comes
// as late as this elastic shear makes it.
#include <optional>

#include "sim/stability/probe.hpp"

namespace triax::sim {

/// A(n), Pa; n a unit vector.
Eigen::Matrix3d acoustic_tensor(const Matrix<Tensor>& stiffness, const Eigen::Vector3d& normal);

struct Localisation {
  /// Least det A(n)/det A_ref(n) of all n: 1 in elasticity, 0 where a band can form first, negative
  /// beyond. (A tangent for which two eigenvalues of A(n) are negative together has a positive
  /// determinant again; on the way there the first has been met.)
  double determinant = 1;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< of the band, n₁ ≥ 0; −n is the same band
  /// Angle between the band and the plane normal to axis 1, rad: its slope in a triaxial test.
  double inclination() const { return std::acos(std::min(std::abs(normal(0)), 1.0)); }
};

/// Over the half sphere of normals, by a grid and refinement to 1e-8 rad (less along a level valley
/// of normals, as turns around the axis of a triaxial specimen are). Where D couples no shear
/// with normal components and no shear with another (principal axes that stay fixed), det A holds
/// squares of n_i only and an octant would do; no such plane or octant is assumed here, since a
/// tangent of a mechanism in a corner, or at a turned stress, has less symmetry.
/// A change of sign through infinity is no band: there the tangent's compliance was singular.
/// Pre-condition: `reference` has positive definite acoustic tensors.
Localisation localisation(const Matrix<Tensor>& tangent, const Matrix<Tensor>& reference);

/// What determinants are compared with: the stiffness C of a stiffness form; of an interpolated
/// form that of the diagonal of ½ (N⁺ + N⁻), which is positive definite, as PointRate::determinant.
Matrix<Tensor> reference_stiffness(const Response<Tensor>& response);

struct StateLocalisation : Localisation {
  ProbeKind kind = ProbeKind::stress;  ///< of the increment whose tangent it is
  double angle = 0;                    ///< α of that increment, rad
};

/// The least of the tangents in equal steps of the directions of a plane, as stress probes and as
/// strain probes (which also reach what no stress increment does: the tangent at a limit). At an
/// axisymmetric state the tensor form of the law answers with σ₂ = σ₃. Empty where no direction has
/// a tangent. Some milliseconds.
std::optional<StateLocalisation> state_localisation(const IncrementalResponse<Tensor>& response,
                                                    ProbePlane plane, int directions = 36);

}  // namespace triax::sim

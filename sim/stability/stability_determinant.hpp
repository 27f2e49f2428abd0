// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The bifurcation criterion in the form of a determinant: on the boundary of the bifurcation domain
// det Mˢ = 0, Mˢ the symmetric part of the compliance in the plane, and the null vector is the
// first unstable direction, if it lies in the zone that M belongs to.
//
// The zones of elastoplastic laws and of octolinear are linear: M is the tangent compliance. Of an
// incrementally nonlinear law (INL2, hypoplasticity) the symmetric part of the tangent is not what
// counts, since W₂ = dσᵗ M(dσ) dσ with an M that turns with dσ. Its place takes
//
//   H(dσ) = ½ ∂²W₂/∂dσ∂dσ,   W₂ = dσᵗ H dσ,   ½ ∂W₂/∂dσ = H dσ     (W₂ is homogeneous of degree 2)
//
// which is Mˢ in a linear zone. A direction is that of a minimum of W₂/|dσ|² exactly where it is
// the eigenvector of its own H with the least eigenvalue: that is the check of the zone. On the
// boundary W₂ and its gradient vanish together, so that H is singular and the direction its null
// vector.
#include <optional>

#include "sim/stability/proportional_control.hpp"

namespace triax::sim {

/// λ₁|λ₂|/(½|Mˢ|²) with the eigenvalues λ₁ ≤ λ₂ of Mˢ: 1 for a multiple of the unit matrix, at most
/// 1, 0 where the determinant vanishes, negative from there on (also where both are).
double relative_determinant(const Eigen::Matrix2d& m);
/// α in [0, π) of the eigenvector of Mˢ with the least eigenvalue; M on (dσ₁, c dσ₃).
double least_direction(const Eigen::Matrix2d& m);

/// H of the direction α on (dσ₁, c dσ₃), 1/Pa: exact in a linear zone, else by differences of the
/// gradient, to 1e-9 (1e-5 of a law that integrates itself). Empty where the law has no answer.
template <class Space>
std::optional<Eigen::Matrix2d> half_hessian(const IncrementalResponse<Space>& response,
                                            double angle);

struct StabilityDeterminant {
  double value = 1;  ///< relative_determinant of H
  double angle = 0;  ///< rad, of the eigenvector, which lies in the zone of H
};

/// The least of all minima of W₂/|dσ|². `directions` are tried for where to look. Empty where every
/// minimum lies on the edge of two zones: there no determinant vanishes when W₂ does.
template <class Space>
std::optional<StabilityDeterminant> stability_determinant(
    const IncrementalResponse<Space>& response, int directions = 36);

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cones of unstable directions of an octolinear response in closed form. In each tensorial zone
//
//   W₂/|dσ|² = vᵗ M v,   v = (sin α, cos α),   M = Q (Eq. 38, four zones) or P (Eq. 39, eight)
//
// is negative within acos(μ/ρ)/2 of the zone's least eigenvector, μ ± ρ the eigenvalues of Mˢ,
// where ρ > |μ|; the arc is cut to the zone, which is the check that the paper asks for below Eq.
// (39). In plane strain dσ₂ = −(N₂₁ dσ₁ + N₂₃ dσ₃)/N₂₂ belongs to the zone too: its sign cuts the
// quadrant of (dσ₁, dσ₃) in two.
#include <optional>
#include <vector>

#include "sim/stability/proportional_control.hpp"

namespace triax::sim {

struct OctolinearZone {
  ZoneSigns signs;          ///< of dσ₁, dσ₂, dσ₃
  double from = 0, to = 0;  ///< its directions, rad, within one quadrant of [0, 2π]
  PlaneCompliance compliance;

  bool contains(double angle) const { return angle >= from && angle <= to; }
};

/// In the order of α. Pre-condition: the form is octolinear.
std::vector<OctolinearZone> octolinear_zones(const InterpolatedForm<Axisymmetric>& form);
/// In plane strain. A zone whose dσ₂ would not have its sign is left out. Pre-condition besides:
/// answers_in_plane_strain(form); else some directions lie in two zones, and others in none.
std::vector<OctolinearZone> octolinear_zones(const InterpolatedForm<Tensor>& form);

/// Whether dε₂ = 0 has one answer in every direction: N₂₂ > 0 on both sides.
bool answers_in_plane_strain(const InterpolatedForm<Tensor>& form);

/// Directions with W₂ < 0, rad; from in [0, 2π), to may lie beyond 2π.
struct UnstableSector {
  double from = 0, to = 0;
};

/// The cones, those of neighbouring zones joined, by `from`.
std::vector<UnstableSector> unstable_sectors(const std::vector<OctolinearZone>& zones);

/// Least W₂/|dσ|² of all directions, 1/Pa: negative exactly if a direction is unstable.
double least_work(const std::vector<OctolinearZone>& zones);

/// Least relative_determinant (stability_determinant.hpp) of the zones that hold their own least
/// eigenvector; empty where none does.
std::optional<double> least_determinant(const std::vector<OctolinearZone>& zones);

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Contact of two spheres, and of a sphere and a rigid wall (Darve, Sibille, Daouadji and Nicot
// 2007, Eq. 42): linear and elastic along the normal without tension, linear in the tangential
// displacement with Coulomb's limit.
//
//   F_n = k_n δ_n, F_n ≥ 0        ΔF_t = k_t Δu_t, |F_t| ≤ tan φ F_n
//
// δ_n is the overlap of the undeformed spheres, the contact lies in its middle. F_t is rotated with
// the contact's frame (its tilt and the mean spin of both spheres about the normal) before it
// grows. Walls are frictionless.
#include <cstdint>

namespace triax::sim {

/// What the paper's "k_n/D_s" means for spheres of radii r₁, r₂.
enum class StiffnessReading : std::uint8_t {
  in_series,  ///< each sphere alone has k_n = E D; two of them in series: 2 E r₁ r₂/(r₁ + r₂)
  literal,    ///< k_n = E D for two equal spheres, twice the other: 4 E r₁ r₂/(r₁ + r₂)
};

struct ContactLaw {
  StiffnessReading reading = StiffnessReading::in_series;
  double stiffness_over_diameter_pa = 356e6;  ///< E = k_n/D_s, > 0
  double tangential_ratio = 0.42;             ///< k_t/k_n, ≥ 0
  double friction_angle = 0.6108652381980153;  ///< φ between grains, rad, 0 to below π/2; here 35°
  double density_kg_per_m3 = 3000;             ///< of the grains, > 0
  /// Cundall's local damping α, 0 to below 1: each component of force and moment is reduced by α
  /// where it does work on the motion and increased by α where it brakes.
  double damping = 0.2;

  friend bool operator==(const ContactLaw&, const ContactLaw&) = default;
};

/// k_n of two spheres, N/m; radii in m.
double normal_stiffness(const ContactLaw& law, double radius1_m, double radius2_m);
/// k_n of a sphere on a wall, N/m: the wall mirrors the sphere.
double wall_stiffness(const ContactLaw& law, double radius_m);
/// tan φ
double friction_coefficient(const ContactLaw& law);
/// Throws std::invalid_argument that names the first value out of its range.
void check(const ContactLaw& law);

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Stress and strain of the axisymmetric (triaxial) specimen: axis 1 is axial, 2 = 3 radial.
// Compression positive throughout, stress in Pa, strain as a plain number.
#include <cmath>
#include <numbers>

namespace triax::sim {

/// Principal stresses of a triaxial specimen (Pa). Whether effective or total is said by the name
/// of the variable that holds them.
struct AxisymmetricStress {
  double axial = 0;   ///< σ₁
  double radial = 0;  ///< σ₂ = σ₃
};

/// Principal strains, or increments of them.
struct AxisymmetricStrain {
  double axial = 0;   ///< ε₁
  double radial = 0;  ///< ε₂ = ε₃
};

/// p = (σ₁ + 2σ₃)/3, Pa
constexpr double mean_stress(const AxisymmetricStress& s) { return (s.axial + 2 * s.radial) / 3; }
/// q = σ₁ − σ₃, Pa; negative in extension
constexpr double deviator_stress(const AxisymmetricStress& s) { return s.axial - s.radial; }
/// ε_v = ε₁ + 2ε₃, work-conjugate to p
constexpr double volumetric_strain(const AxisymmetricStrain& e) { return e.axial + 2 * e.radial; }
/// ε_q = 2(ε₁ − ε₃)/3, work-conjugate to q
constexpr double shear_strain(const AxisymmetricStrain& e) { return 2 * (e.axial - e.radial) / 3; }

/// Mobilised friction angle (rad) at the stress ratio η = q/p':
/// sin φ_mob = 3η/(6 + η) in compression, 3|η|/(6 − |η|) in extension (η < 0).
/// NaN where no angle exists: η > 3 (tension in σ₃') or η < −3/2.
inline double mobilised_friction_angle(double eta) {
  return std::asin(eta >= 0 ? 3 * eta / (6 + eta) : -3 * eta / (6 + eta));
}

/// Slope of the Mohr-Coulomb line in compression, M = 6 sin φ/(3 − sin φ); φ in rad.
inline double stress_ratio_at_friction_angle(double phi) {
  return 6 * std::sin(phi) / (3 - std::sin(phi));
}

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::sim {

inline constexpr double kAtmosphere_pa = 101325;
/// Volume of air that a volume of water dissolves, at the pressure of both (20 °C).
inline constexpr double kAirSolubility = 0.02;

/// What air leaves of a space to water. Boyle and Henry, always in equilibrium and at constant
/// temperature: with the amount of air N (absolute pressure × volume), p = u + 1 atm, free air V_g
/// and water V_w in a space V,
///
///   p (V_g + h V_w) = N,   V_g + V_w = V   →   V_w = (V − N/p)/(1 − h)
///
/// as long as N > h p V; beyond, all air is dissolved and V_w = V. From a saturation S₀ at p₀ and
/// at constant V_w that is at
///
///   p = p₀ (1 − S₀ (1 − h))/(S₀ h)
struct AirySpace {
  double water_m3 = 0;       ///< V_w
  double water_slope = 1;    ///< ∂V_w/∂V
  double compliance = 0;     ///< ∂V_w/∂p, m³/Pa
  double air_displaces = 0;  ///< −∂V_w/∂N, 1/Pa
  double dissolved_pa = 0;   ///< dissolved air in a volume of water, N per m³
};

/// Pre-conditions: space ≥ 0, amount ≥ 0. A pressure below 1 % of the atmosphere counts as that:
/// the law of ideal gases without vapour ends there.
AirySpace airy_space(double space_m3, double pore_pressure_pa, double air_pa_m3);

/// N of a space with this saturation, which is above 0 and at most 1; 0 where it is 1.
double amount_of_air(double space_m3, double saturation, double pore_pressure_pa);

/// Pore pressure (Pa above the atmosphere) from which on all air is dissolved; see above.
double dissolving_pressure_pa(double saturation, double pore_pressure_pa);

}  // namespace triax::sim

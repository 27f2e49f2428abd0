// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Second-order work of an axisymmetric increment, per unit volume, in the three forms of Darve,
// Sibille, Daouadji and Nicot (2007). Compression positive; stresses are effective, in Pa.
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::sim {

/// Second-order work per unit volume, Pa (or Pa/s² when rates are given instead of increments:
/// the sign and the normalised value are the same).
struct SecondOrderWork {
  double small_strain = 0;  ///< dσ′:dε, Eq. (23)
  double eulerian = 0;  ///< (dσ′ + div(du) σ′ − σ′ Lᵗ dt) : L dt, Eq. (10) per current volume
  double semi_lagrangian = 0;  ///< dΠ : ∂(du)/∂X, Eq. (7) per volume at the start of shear
  double normalised = 0;  ///< dσ′:dε/(|dσ′| |dε|) in [−1, 1]; 0 where one norm vanishes
};

/// The state at which the increment is taken.
struct StretchedState {
  AxisymmetricStress effective_stress;  ///< σ′, Pa
  AxisymmetricStrain strain;  ///< engineering strain since the reference, stretch λ = 1 − ε
};

/// Second-order work of the increment (dσ′, dε) at `at`; dε are increments of the engineering
/// strains. Pre-condition: both strains below 1.
SecondOrderWork second_order_work(const StretchedState& at,
                                  const AxisymmetricStress& stress_increment,
                                  const AxisymmetricStrain& strain_increment);

}  // namespace triax::sim

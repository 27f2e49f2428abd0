// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Second-order work of an axisymmetric increment, per unit volume, in the three forms of Darve,
// Sibille, Daouadji and Nicot (2007). Compression positive; stresses are effective, in Pa.
//
// A test measures ε₁ = −ΔH/H and ε_v = −ΔV/V of a right cylinder. Their small-strain companion is
// ε₃ = (ε_v − ε₁)/2, which makes σ₁ε₁ + 2σ₃ε₃ = qε_q + pε_v: the strain of Eq. (23). It is not the
// lateral strain of the specimen: the volume is (1 − ε₁) λ₃², so that the finite forms have
//
//   λ₁ = 1 − ε₁,   λ₃ = √((1 − ε_v)/(1 − ε₁)),   d ln λ₃ = ½ (d ln(1 − ε_v) − d ln(1 − ε₁))
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
  AxisymmetricStrain strain;            ///< ε₁ and (ε_v − ε₁)/2 since the reference
};

/// Second-order work of the increment (dσ′, dε) at `at`; dε are the increments of the two strains.
/// Pre-condition: ε₁ and ε_v below 1.
SecondOrderWork second_order_work(const StretchedState& at,
                                  const AxisymmetricStress& stress_increment,
                                  const AxisymmetricStrain& strain_increment);

}  // namespace triax::sim

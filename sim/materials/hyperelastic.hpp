// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Elasticity whose stiffness grows with a power n of the mean effective stress and that has an
// energy (Houlsby, Amorosi and Rojas 2005, Géotechnique 55, 383). Its complementary energy is
//
//   Ψ(σ) = p_o²/((1 − n)(2 − n) K_o) − p_ref/((1 − n) K_ref)·p     p_o² = p² + (1 − n)(K/G) s:s/2
//   K_o = K_ref (p_o/p_ref)ⁿ,  G_o = G_ref (p_o/p_ref)ⁿ            ε = ∂Ψ/∂σ
//
// (logarithms in its place for n = 1), so that the stiffness ∂σ/∂ε is
//
//   C = K_o δδᵗ + 2 G_o (I − δδᵗ/3) + n K_o (σσᵗ/p_o² − δδᵗ)
//
// Under isotropic stress that is the law with K and G growing as pⁿ. With shear volume and shape
// are coupled: p grows with shear at constant volume, as it must where G grows with p, for the
// strain and the work of every closed cycle of stress to vanish. K and G at p alone, without the
// last term (hypoelasticity), give work away for nothing: over the rectangle p₁, p₂ by q₁, q₂
//
//   ∮ σ:dε = (q₂² − q₁²)/6 (1/G(p₂) − 1/G(p₁))     p₁ → p₂ at q₁, q₁ → q₂ at p₂, and back
//
// p is p′ (Pa), compression positive. 0 ≤ n ≤ 1; C is homogeneous of degree n in σ, symmetric and
// positive definite.
#include <cmath>
#include <stdexcept>

#include "sim/law/parameters.hpp"

namespace triax::sim {

/// p_o. Pre-condition: p > 0.
template <class Space>
double equivalent_pressure(const Vector<Space>& stress, double exponent, double bulk_over_shear) {
  const double p = mean_stress<Space>(stress);
  return std::sqrt(p * p +
                   (1 - exponent) * bulk_over_shear * deviator<Space>(stress).squaredNorm() / 2);
}

/// C with K_o and G_o of p_o, Pa.
template <class Space>
Matrix<Space> hyperelastic_stiffness(const Vector<Space>& stress, double p_o, double exponent,
                                     double bulk_pa, double shear_pa) {
  const Vector<Space> ratio = stress / p_o, unit = identity<Space>();
  return isotropic_stiffness<Space>(bulk_pa, shear_pa) +
         exponent * bulk_pa * (ratio * ratio.transpose() - unit * unit.transpose());
}

/// The choice as a parameter of a law, of whom a double holds it: 1 yes, 0 no.
inline ParameterDescription hyperelastic_choice() {
  return {.key = "hyperelastic",
          .symbol = "",
          .unit = "",
          .meaning =
              "1: elastic stiffness from an energy, 0: K and G at p' alone, whose closed "
              "cycles of p' and q gain or lose work",
          .range = {.at_least = 0, .at_most = 1},
          .usual = 0};
}

/// Throws std::invalid_argument unless it is 0 or 1.
inline void check_hyperelastic(double choice) {
  if (choice != 0 && choice != 1)
    throw std::invalid_argument("hyperelastic is " + short_number(choice) + ", must be 0 or 1");
}

}  // namespace triax::sim

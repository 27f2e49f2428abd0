// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a specimen of grains is thought to answer to the next small increment: Δσ ≈ K Δε, from the
// increments that it made.
#include "sim/mechanics/space.hpp"

namespace triax::sim {

struct SecantStiffness {
  Matrix<Axisymmetric> elastic = Matrix<Axisymmetric>::Zero();    ///< Pa; of a reversal
  Matrix<Axisymmetric> going_on = Matrix<Axisymmetric>::Zero();   ///< Pa; of more of the same
  Vector<Axisymmetric> direction = Vector<Axisymmetric>::Zero();  ///< of the last increment, unit

  /// K for an increment in this direction: the elastic one against the last increment.
  const Matrix<Axisymmetric>& towards(const Vector<Axisymmetric>& strain) const {
    return strain.dot(direction) < 0 ? elastic : going_on;
  }

  /// The same with what this increment showed: the least change of K with K Δε = Δσ (Broyden), from
  /// the elastic one where it went back.
  SecantStiffness with(const Vector<Axisymmetric>& strain,
                       const Vector<Axisymmetric>& stress) const;
};

/// K + (Δσ − K Δε) Δεᵀ/|Δε|². Pre-condition: Δε is not 0.
Matrix<Axisymmetric> corrected(const Matrix<Axisymmetric>& stiffness,
                               const Vector<Axisymmetric>& strain,
                               const Vector<Axisymmetric>& stress);

}  // namespace triax::sim

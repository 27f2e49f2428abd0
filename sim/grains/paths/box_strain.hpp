// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Strains the box of grains by a finite amount so gently that what the walls carry afterwards is
// that of a rest.
#include <cstdint>

#include "sim/grains/engine/grains.hpp"
#include "sim/mechanics/space.hpp"

namespace triax::sim {

/// How fast. Time of the grains is not that of a test: below the bound the answer hardly depends on
/// the rate.
struct StrainPace {
  /// Bound of I = |ε̇| d √(ρ/p), d the mean diameter, ρ that of the grains, |ε̇| the norm of the
  /// strain rate; > 0. At 1e-4 inertia adds less than a thousandth to the stress ratio.
  double inertial_number = 1e-4;
  /// p below which the bound falls no further, Pa, > 0: without it a specimen that has liquefied
  /// would never move.
  double least_pressure_pa = 5e3;
  /// Stress (Pa, > 0) that need not be told: an increment that could change no more than this takes
  /// fewer steps in proportion.
  double small_stress_pa = 1;
};

/// Steps that a wave takes across the largest side of the box, at least 1. The wave's modulus is
/// taken as kWaveModulus E, low for a packing: too many steps rather than too few.
inline constexpr double kWaveModulus = 0.2;
std::int64_t crossing_steps(const GrainState& state);

/// Steps of one such motion: the rate rises, stays, falls; then the walls stand.
struct StrainSteps {
  std::int64_t rise = 0, level = 0, rest = 0;
  std::int64_t all() const { return 2 * rise + level + rest; }
};

/// For an increment of this size |Δε|: a crossing to rise and one to fall, as long at the bound as
/// the pace asks for, two crossings of rest. None where the size is 0.
StrainSteps strain_steps(const GrainState& state, double size, const StrainPace& pace);

/// Moves the walls by natural strains (axial, √2 radial), both radial axes alike, and leaves them
/// at rest. A function of the state that is continuous in the strain as long as the steps are the
/// same. Throws GrainsFailed (guarded_steps.hpp), with the state somewhere on its way.
void strain_box(Grains& grains, const Vector<Axisymmetric>& strain, const StrainSteps& steps);

}  // namespace triax::sim

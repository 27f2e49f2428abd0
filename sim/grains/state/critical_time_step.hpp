// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The longest step at which the explicit integration of the contacts is stable.
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// Δt = 2/ω, s, with a bound of the highest angular frequency by the elements' own (Irons): each
/// grain's mass is shared among its contacts in proportion to their stiffness, so that
///
///   ω² ≤ max over contacts (K_i/m_i + K_j/m_j),   K_i = Σ max(k_n, 7/2 k_t) over the contacts of i
///
/// (7/2: sliding of a sphere's surface moves 1/m + r²/I = 7/(2m)). A grain counts as having at
/// least the two contacts of one held between its likes, so that a loose cloud has a step too.
double critical_time_step(const GrainState& state);

/// The step to take where none is given, s: 0.6 of the critical one.
double usual_time_step(const GrainState& state);

}  // namespace triax::sim

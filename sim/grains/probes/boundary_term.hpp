// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The boundary term of Eq. (22): how unsteadily the boundary moves while an increment is put on.
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// 1/V Σ_walls F_ext · δ²u, J/m³: F_ext is the force of a wall on the specimen at the start, V its
/// volume then, and δ²u = ü T² the second difference of the wall's way over a ramp of duration T,
///
///   δ²u = 2 ((u(T) − u(sT))/(1 − s) − u(sT)/s)      s = 1/2: 4 (u(T) − 2 u(T/2))
///
/// Walls that move steadily give 0. `middle` is the box after the share s of the ramp, 0 < s < 1,
/// `end` after all of it.
double boundary_term(const GrainState& start, const GrainBox& middle, double share,
                     const GrainBox& end);

}  // namespace triax::sim

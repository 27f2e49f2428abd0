// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether a GrainState that comes from outside is one that the engine can go on from. A checksum
// tells of accidents; a file may also be made by hand, or by a program in error.
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// Throws std::invalid_argument, one line that says what is wrong:
///  - law, time step, margins, box, drives out of their ranges, or so large that a step would not
///    be finite
///  - a grain with a value that is not finite, a radius or mass not above 0, a mass that is not
///    that of its size, a centre outside the box
///  - ids that are no permutation; pairs or grains at walls that are out of order, listed twice, no
///    part of the longer list or no grains of the specimen
/// Time and memory grow with the number of grains and pairs.
void check(const GrainState& state);

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The neighbour lists of a GrainState. Two levels: `listed` holds every pair (and grain at a wall)
// with a gap below margin.listed_m when the grains were last sorted; `near`, which every step
// visits, those with a gap below margin.near_m when it was last chosen.
//
// A pair not near cannot touch while the two fastest things together travelled less than
// margin.near_m; a pair not listed cannot become near while the two that moved farthest together
// moved less than margin.listed_m − margin.near_m. Walls count as grains do.
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// Sorts the grains into cells, lists the pairs, chooses the near ones. Tangential forces of
/// touching pairs are kept.
void sort_grains(GrainState& state);

/// To be called when neighbours.travelled_m reaches margin.near_m: chooses the near pairs again, or
/// sorts where the longer list may have missed one.
void renew_neighbours(GrainState& state);

/// Margins that suit slow deformation of spheres whose smallest has `radius_m`.
NeighbourMargin neighbour_margin(double radius_m);

}  // namespace triax::sim

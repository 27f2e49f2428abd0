// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>

#include "lab/measured/path_rates.hpp"

namespace triax::lab {

/// Where a specimen that fell between two readings lost its equilibrium, from the readings before.
/// At a limit point what the programme drives on is a parabola of the response: the time t of the
/// axial strain, t = t_c − a (ε_c − ε)². So is q where it is not held, and where its vertex lies
/// before that of t by more than three standard errors, second-order work vanished there first (a
/// spring lets q pass its peak; a load does not). Both are least squares over the last readings;
/// the vertex counts up to half an interval beyond the last of them. q, p′, u and ε_v are parabolas
/// of ε, too. `samples`: single readings, oldest first, the last one that before the fall. Empty
/// for fewer than 8 of them or where they do not curve that way.
std::optional<PathPoint> fit_fall(std::span<const PathSample> samples, bool held_q);

}  // namespace triax::lab

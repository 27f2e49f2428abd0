// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/collapse/path_history.hpp"
#include "lab/collapse/path_rates.hpp"

namespace triax::lab {

/// The point with its values, where a curve was fitted, within what the single readings around it
/// span: nothing was measured beyond. These are its two neighbours where a few readings were
/// enough for it, else the three on each side, among which noise lies on both sides of a fair
/// value. As it is where the history knows that part of the path in blocks only.
PathPoint within_measured(PathPoint point, const PathHistory& history);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/measured/path_rates.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// The instant of one state; time is left out where the record has none.
Instant instant_of(const State& state, bool has_time);
/// The instant of a smoothed point of the path, at the nearest reading.
Instant instant_of(const PathPoint& point, bool has_time);

/// The moment of one state, likewise.
Moment moment_of(const State& state, bool has_time);

}  // namespace triax::lab

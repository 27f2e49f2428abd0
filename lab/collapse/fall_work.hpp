// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "lab/measured/path_rates.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Second-order work of a fall: of the finite increment between the reading before it and the one
/// that shows it. A fall is over before any window of readings is full; between the two the
/// specimen takes up strain (dε₁ > 0) while its q goes, and dσ′:dε of what was read is negative.
struct FallWork {
  double normalised = 0;  ///< dσ′:dε/(|dσ′||dε|), Eq. (23)
  double error = 0;       ///< standard error of it, from the noise of both readings
  std::string evidence;   ///< the sentence that proves it
};

/// Empty unless negative beyond three standard errors. `near` is the last point of the path before
/// the fall: its scatter is the readings' noise, taken as white.
std::optional<FallWork> work_of_fall(const State& before, const State& after,
                                     const PathPoint& near);

}  // namespace triax::lab

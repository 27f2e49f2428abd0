// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/results/summary.hpp"

namespace triax::src {

/// "on imminent: switched to displacement at 0.05 mm/min; axial strain 0.283 %, ... at reading
/// 1522, 50.7 min"; the axial strain at the end of the test with and without the guard.
std::vector<std::string> guard_lines(const lab::GuardOutcome& guard);

}  // namespace triax::src

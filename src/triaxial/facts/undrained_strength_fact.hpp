// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/results/summary.hpp"

namespace triax::src {

/// "c_u = 88.0 kPa at 10.5 % axial strain (half of the largest q)", with the limits of the
/// standards if q had no peak before them.
std::vector<std::string> undrained_strength_lines(const lab::UndrainedStrength& strength);

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "bench/detection/table.hpp"

namespace triax::bench {

/// How many collapses the monitor places worse than the bounds ask of 95 %, or notices more than
/// 800 readings late, and in which programmes: a line each.
std::string tails(const std::vector<TrialResult>& results, const Bounds& bounds);

}  // namespace triax::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The names of outcomes and events of a path, as JSON and text have them.
#include <string>

#include "sim/point/path_runner.hpp"

namespace triax::src {

/// "accepted", "inaccurate", "lost_control", "failed".
std::string word_of(sim::StepOutcome outcome);
/// "end_condition", "second_order_work", "peak", "control_limit".
std::string word_of(sim::PathEventKind kind);

}  // namespace triax::src

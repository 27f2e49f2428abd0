// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lab/results/record_header.hpp"

namespace triax::src {

/// Joules with a prefix that keeps the number readable: "12.3 mJ".
std::string joules(std::optional<double> j);

/// One sentence a run-away: when, largest kinetic energy, Eq. (5) as measured, how it ended. Beyond
/// the first few the rest is counted.
std::vector<std::string> run_away_lines(const std::vector<lab::RunAwayTruth>& run_aways);

}  // namespace triax::src

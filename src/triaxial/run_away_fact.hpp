#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lab/results/record_header.hpp"

namespace triax::src {

/// E_c / (−W₂/2) over the first resolved increment of a run-away: what was measured of Eq. (5),
/// 2 E_c = −W₂. It tends to 1 as the increment shrinks where W₂ is already negative at the start;
/// from a limit point, where W₂ passes through 0, the third order leads and the limit is 2/3. Empty
/// where either is unknown or W₂ is 0.
std::optional<double> kinetic_energy_ratio(const lab::RunAwayTruth& run_away);

/// Joules with a prefix that keeps the number readable: "12.3 mJ".
std::string joules(std::optional<double> j);

/// One sentence a run-away: when, largest kinetic energy, Eq. (5) as measured, how it ended. Beyond
/// the first few the rest is counted.
std::vector<std::string> run_away_lines(const std::vector<lab::RunAwayTruth>& run_aways);

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"
#include "lab/warning/cyclic_warning.hpp"

namespace triax::lab {

/// "onset forecast at η 0.598 (0.571 to 0.625), 3.20 kPa of q and 120 s left at the present rate",
/// or "the probability of failure within one load cycle is 83 % after 7.5 cycles".
std::string describe(const Forecast& forecast);
/// "; cycles are compared again since cycle 3.5: the load became larger", or nothing.
std::string restart_words(const CyclicWarning& warning);
/// What the guard did, and where: "on imminent: handed over to displacement at 0.05 mm/min; ...".
std::string describe(const GuardOutcome& guard);
/// `level`, approaching or imminent, was reached with that forecast.
Event level_event(WarningLevel level, const Forecast& forecast);
/// What had been said is said no longer; `reason` may be empty: the forecast that stands is the
/// reason.
Event withdrawal_event(const State& now, bool has_time, const std::optional<Forecast>& forecast,
                       const std::string& reason);

}  // namespace triax::lab

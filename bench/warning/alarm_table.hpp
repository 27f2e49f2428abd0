// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "bench/warning/alarm_trial.hpp"

namespace triax::bench {

/// Prints what was said in these tests, and whether the bounds of the alarm are held; with
/// `failures` those that missed one, by name.
///
///   warned    `imminent` stood before the fall (load, dead load, spring, held q), or within ten
///             readings after the onset (displacement)
///   lead      time from `imminent` to the fall: its median
///   in time   share of tests in which it is a tenth of the stage or 60 s, whichever is shorter
///   |error|   of η forecast with that share of the stage's time left: median, share within 0.02
///   covers    share of tests whose 90 % interval holds the true η
///   controls  tests that stay stable: `imminent` ever, `approaching` at the end, points of
///             second-order work under a level. Those near zero work, which these instruments
///             cannot tell from an onset, are counted apart (AlarmTrial::near_zero)
/// `title` stands above them.
bool print_alarm_trials(const std::string& title, const std::vector<AlarmTrial>& trials,
                        bool failures);

}  // namespace triax::bench

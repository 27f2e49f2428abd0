// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The failures to look at: as records, which triax replays and draws.
#include <string>
#include <vector>

#include "bench/warning/alarm_trial.hpp"

namespace triax::bench {

/// Writes into `folder`, which exists, records of the five worst trials of each kind: falls that
/// were missed (the longest stages first), controls called imminent (the farthest from zero work
/// first), errors of the forecast at a tenth left. Named KIND-PLACE.csv. Runs them once more.
/// trials[i] is of subjects[i % subjects.size()], as run_alarm_trial made it. Throws what the
/// record's writer throws.
void write_worst(const std::vector<AlarmTrial>& trials, const std::vector<Subject>& subjects,
                 const std::string& folder);

}  // namespace triax::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "bench/detection/trial.hpp"

namespace triax::bench {

/// The bounds that the detection must hold over all tests.
struct Bounds {
  int tests = 2000;
  double detection = 0.995, false_alarm = 0.001, eta_error = 0.01, delay = 5;
};

/// The table: for each method a line a type of programme and one over all.
std::string table(const std::vector<TrialResult>& results);

/// What of the bounds does not hold, a sentence each; empty if all do. `whole`: the number of tests
/// is judged, too.
std::vector<std::string> broken(const std::vector<TrialResult>& results, const Bounds& bounds,
                                bool whole);

/// A heading and one line a test and method.
std::string csv(const std::vector<TrialResult>& results);

}  // namespace triax::bench

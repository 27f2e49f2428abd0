// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <vector>

#include "bench/warning/hindsight.hpp"

namespace triax::bench {

/// One collapse, and what was or could have been said of it at a tenth of the stage left.
struct LimitTrial {
  AlarmTrial alone, one, two, by_law;  ///< by itself, told of one earlier test, of two, of a
                                       ///< simulation
  Members members;
  std::optional<double> law;  ///< η of SimulatedBefore
};

/// Prints, by specimen (programme, law, density), the share of tests within 0.02 of η:
///
///   alone      the alarm as it is
///   window     the one extrapolation (hindsight.hpp) that does best over all tests of the
///              specimen, chosen with the truth
///   bend       the alarm's forecast with the one bend that does best likewise:
///              now + b (forecast − now)
///   any        some extrapolation of the test is within 0.02, whichever: no forecast can know
///   its law    the simulation by its law (SimulatedBefore)
///   one, two   the alarm, told of so many earlier tests
///   told       the alarm, told of that simulation
void print_limits(const std::vector<LimitTrial>& trials);

}  // namespace triax::bench

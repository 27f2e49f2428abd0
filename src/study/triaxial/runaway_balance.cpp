// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/runaway_balance.hpp"

#include <cmath>

namespace triax::study {
namespace {

/// Between 2/3 and 1.
constexpr double kBetweenStarts = 0.8;

}  // namespace

RunawayBalance balance_of(const lab::RunAwayTruth& runaway) {
  RunawayBalance balance;
  if (runaway.kinetic_energy_j && runaway.second_order_work_j) {
    balance.half_work_j = -*runaway.second_order_work_j / 2;
    const double ratio = -2 * *runaway.kinetic_energy_j / *runaway.second_order_work_j;
    if (std::isfinite(ratio)) balance.ratio = ratio;
  }
  if (runaway.expected_ratio)
    balance.start = *runaway.expected_ratio < kBetweenStarts ? RunawayStart::limit_point
                                                             : RunawayStart::past_peak;
  balance.rise_s = runaway.largest_at_s - runaway.start_s;
  if (runaway.end_s) balance.duration_s = *runaway.end_s - runaway.start_s;
  return balance;
}

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/unread_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::lab {

void UnreadSteps::Rate::add(double rate) {
  if (std::isfinite(rate)) mean += (rate - mean) / static_cast<double>(std::min(++steps, kMemory));
}

bool UnreadSteps::add(const State& state) {
  if (!std::isfinite(state.q)) return false;
  const auto before = std::exchange(before_, state);
  if (!before) return false;
  auto lapse = static_cast<double>(state.reading - before->reading);
  if (has_time_ && state.time_s > before->time_s) lapse = state.time_s - before->time_s;
  const double leap = std::fabs(state.strain.axial - before->strain.axial);
  const double loss = std::fabs(before->q) - std::fabs(state.q);
  const double strain_rate = leap / lapse, q_rate = std::fabs(state.q - before->q) / lapse;
  const bool leaps = leap >= assessment_limits::kRunaway && strain_.outruns(strain_rate) &&
                     -loss < leap / 2 * std::fabs(before->q);
  const bool falls = loss > kFall * std::fabs(before->q) && q_.outruns(q_rate);
  strain_.add(strain_rate);
  q_.add(q_rate);
  return leaps || falls;
}

}  // namespace triax::lab

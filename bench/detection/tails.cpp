// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/tails.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace triax::bench {

std::string tails(const std::vector<TrialResult>& results, const Bounds& bounds) {
  constexpr double kLateNotice = 800;  // readings
  int collapses = 0;
  std::map<std::string, int> far, late, unnoticed;
  for (const TrialResult& r : results) {
    if (!r.comparable() || !r.collapses) continue;
    const Outcome& ours = r.outcomes[0];
    const std::string where = fmt::format("{} ({})", r.programme, r.material);
    ++collapses;
    if (std::abs(ours.eta_error.value_or(0)) > bounds.eta_error) ++far[where];
    if (std::abs(double(ours.delay.value_or(0))) > bounds.delay) ++late[where];
    if (double(ours.notice_delay.value_or(0)) > kLateNotice) ++unnoticed[where];
  }
  std::string text = fmt::format("\nof {} collapses\n", collapses);
  const auto add = [&](const std::string& what, const std::map<std::string, int>& found) {
    int sum = 0;
    for (const auto& [where, count] : found) sum += count;
    text += fmt::format("{:<46}{:>6}\n", what, sum);
    for (const auto& [where, count] : found) text += fmt::format("    {:<42}{:>6}\n", where, count);
  };
  add(fmt::format("eta more than {:g} off", bounds.eta_error), far);
  add(fmt::format("more than {:g} readings off", bounds.delay), late);
  add(fmt::format("noticed after more than {:g} readings", kLateNotice), unnoticed);
  return text;
}

}  // namespace triax::bench

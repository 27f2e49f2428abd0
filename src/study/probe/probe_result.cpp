// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/probe_result.hpp"

#include <algorithm>
#include <cmath>

namespace triax::study {

bool ProbeResult::has_first() const {
  return many && std::ranges::none_of(states, [](const auto& s) { return s.test.has_value(); });
}

std::optional<FirstUnstable> ProbeResult::first_unstable() const {
  if (!has_first() || !path.empty()) return isolated;
  const ProbedState* first = nullptr;
  for (const ProbedState& state : states)
    if (state.circle.unstable() &&
        (first == nullptr || std::abs(state.eta()) < std::abs(first->eta())))
      first = &state;
  return first == nullptr ? std::nullopt : std::optional(first->as_first());
}

bool ProbeResult::any_answer() const {
  return std::ranges::any_of(states, [](const auto& s) { return s.circle.least.answered; });
}

}  // namespace triax::study

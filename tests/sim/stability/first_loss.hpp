// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <optional>

#include "sim/stability/first_negative.hpp"

// The first loss of a criterion along a line of states, for tests that follow one.
namespace triax::sim::test {

/// Positive while something holds; empty where it has no value, which counts as holding.
using Criterion = std::function<std::optional<double>(double at)>;

struct LossOptions {
  int steps = 100;           ///< equal ones: what comes and goes within one is not seen
  double precision = 1e-12;  ///< of the place, as a part of the whole line
};

/// The first place from `from` towards `to` where the criterion is negative; `from` if it is so
/// there already. Empty: nowhere.
inline std::optional<double> first_loss(const Criterion& criterion, double from, double to,
                                        const LossOptions& options = {}) {
  const auto value = [&criterion](double at) { return std::optional(criterion(at).value_or(1)); };
  double before = from, last = *value(from);
  if (last < 0) return from;
  for (int i = 1; i <= options.steps; ++i) {
    const double here = from + (to - from) * i / options.steps, found = *value(here);
    if (found < 0)
      return first_negative(before, last, here, found, options.precision * std::abs(to - from),
                            value);
    before = here;
    last = found;
  }
  return std::nullopt;
}

}  // namespace triax::sim::test

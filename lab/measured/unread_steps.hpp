// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Steps between two readings in which a specimen ran away: nothing was read between them.
#include <cstdint>
#include <optional>

#include "lab/measured/assessment_limits.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Whether a line from one reading to the next would show what nobody measured. The step is one in
/// which, at more than kBurst (assessment_limits.hpp) times its mean rate so far (per second; per
/// reading without time),
///   the axial strain leaps by kRunaway or more while |q| did not grow by half as much of itself
///   (as in a step of the load), or |q| falls by kFall of what it was.
/// Values that are not known (NaN) are passed over.
class UnreadSteps {
 public:
  static constexpr double kFall = 0.25;  ///< of |q|

  explicit UnreadSteps(bool has_time) : has_time_(has_time) {}

  /// Every state, in order: whether the step to this one is such a step.
  bool add(const State& state);

 private:
  static constexpr std::int64_t kKnown = 3;  ///< steps from which a rate is known
  static constexpr std::int64_t kMemory = 64;
  /// One quantity from step to step.
  struct Rate {
    double mean = 0;
    std::int64_t steps = 0;
    bool outruns(double rate) const {
      return steps >= kKnown && rate > assessment_limits::kBurst * mean;
    }
    void add(double rate);
  };

  bool has_time_;
  std::optional<State> before_;
  Rate strain_, q_;
};

}  // namespace triax::lab

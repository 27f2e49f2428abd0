// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <optional>
#include <utility>

#include "lab/results/state.hpp"

namespace triax::lab {

/// The state with the largest |q| of a path. One that has more than twice the |q| of the state
/// before it, or the other sign, waits for the next: where that does not have half of it either it
/// was a spike of the load cell, at the end of a record for one, where no reading follows by which
/// its health could be told. A state of which q is not known is passed over.
class LargestStrength {
 public:
  void add(const State& state) {
    if (std::isnan(state.q)) return;
    if (const auto leap = std::exchange(leap_, std::nullopt); leap && shares(state, *leap))
      take(*leap);
    if (!last_ || shares(*last_, state))
      take(state);
    else
      leap_ = state;
    last_ = state;
  }
  const std::optional<State>& state() const { return largest_; }

 private:
  /// Whether `one` has half of the q of `other`, on its side.
  static bool shares(const State& one, const State& other) {
    return one.q * std::copysign(1.0, other.q) >= std::fabs(other.q) / 2;
  }
  void take(const State& state) {
    if (!largest_ || std::fabs(state.q) > std::fabs(largest_->q)) largest_ = state;
  }

  std::optional<State> last_, leap_, largest_;
};

}  // namespace triax::lab

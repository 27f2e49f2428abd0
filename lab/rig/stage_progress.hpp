// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far a stage of a programme has come towards its ends.
#include <algorithm>
#include <array>
#include <cmath>

#include "lab/programmes/programme.hpp"
#include "lab/rig/seen.hpp"

namespace triax::lab {

class StageProgress {
 public:
  void begin_stage(const Seen& seen) {
    for (int i = 0; i < kEndQuantityCount; ++i)
      start_[static_cast<std::size_t>(i)] = seen.value(static_cast<EndQuantity>(i));
  }
  /// Of the way from its start to the end that is nearest, 0 to 1.
  double share(const Stage& stage, const Seen& seen) const {
    double done = 0;
    for (const EndCondition& end : stage.end) {
      const double start = start_[static_cast<std::size_t>(end.quantity)];
      const double way = (end.above ? *end.above : *end.below) - start;
      const double share = (seen.value(end.quantity) - start) / way;
      if (std::isfinite(share)) done = std::max(done, share);
    }
    return std::min(done, 1.0);
  }

 private:
  std::array<double, kEndQuantityCount> start_{};
};

}  // namespace triax::lab

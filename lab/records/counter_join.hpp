// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "lab/records/findings.hpp"
#include "lab/results/reading.hpp"

namespace triax::lab {

/// Joins counters that an operator set to zero between two stages: displacement, back and cell
/// volume. The assumption, which the finding states with the size of the jump, is that nothing
/// moved meanwhile. A load cell that was set to zero is reported and left as it is: the specimen
/// may have been unloaded.
///
/// A counter counts as reset if it begins a stage within 2 % of zero while it had left the stage
/// before at more than what the channel can have drifted (RawChannel::drift_si).
class CounterJoin {
 public:
  CounterJoin();

  /// `si` are the values of the next row; joined ones are replaced.
  void apply(std::array<double, kQuantityCount>& si, int stage, bool stage_begins,
             std::int64_t line, Findings& findings);
  /// Whether the counter of that channel was joined so far.
  bool joined(Quantity quantity) const;

 private:
  struct Counter {
    Quantity quantity;
    double drift;  // SI, a change that is no reset
    bool joins;
    double last = kMissing;  // as the file had it
    double offset = 0;
    bool joined = false;
  };
  std::vector<Counter> counters_;
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the sensors of a test say about each other and about the apparatus, in constant memory: the
// slow faults (drift, a leak, a blocked line, a valve that does not close) that no single channel
// shows.
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/reduction/closed_valve.hpp"
#include "lab/reduction/consolidation_end.hpp"
#include "lab/reduction/rate_check.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

class CrossChecks {
 public:
  explicit CrossChecks(const RecordHeader& header);

  /// In order. A channel that cannot be believed is missing (NaN) from `reading` here.
  void add(const Reading& reading, const State& state);
  /// Of what the record holds: consolidation, zero_difference, rate, undrained_volume. The
  /// rate is judged before reading `onset`, the onset of collapse, if any.
  std::vector<Check> checks(std::optional<std::int64_t> onset) const;

 private:
  RecordHeader header_;
  double volume_m3_ = 0;  ///< as built; 0: unknown
  ConsolidationEnd consolidation_;
  RateCheck rate_;
  ClosedValve valve_;
  bool sheared_ = false;
};

/// The notes of the checks that failed, as warnings.
std::vector<Warning> warnings_of(const std::vector<Check>& checks);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which readings of which channel cannot be believed, and what follows from them, for drawings.
#include <cstdint>
#include <vector>

#include "lab/health/record_health.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Readings from..until, both inclusive, of a channel that was dead, saturated, missing or a spike.
struct FaultySpan {
  Quantity channel{};
  std::int64_t from = 0, until = 0;
  bool lasts = false;  ///< `until` is the last reading so far
};

/// Collects the spans of a test from its readings, in constant memory beside them. Spans are those
/// of RecordHealth, without channels that the header vouches for, without gaps of up to
/// sensor_limits::kMissing readings, and without a volume that is not logged while the drainage is
/// closed.
class FaultySpans {
 public:
  explicit FaultySpans(const RecordHeader& header) : header_(header), health_(header) {}

  /// Every reading, in order.
  void add(const Reading& reading);
  /// Of all readings so far.
  std::vector<FaultySpan> spans() const;

 private:
  struct Found {
    FaultySpan span;
    SensorFault fault{};
  };
  bool counts(const RecordHealth::Wrong& wrong, int stage) const;

  RecordHeader header_;
  RecordHealth health_;
  std::vector<Found> found_;
  std::int64_t last_ = -1;
};

/// Removes from a reading and its state what was read on `channel` and what is reduced from it.
void remove_channel(Quantity channel, const RecordHeader& header, Reading& reading, State& state);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Computes the second-order work of the measured path, one state at a time, in constant memory, and
// reports when, how and by which criteria the specimen lost sustainability
// (docs/explanation/detection.md).
#include <functional>
#include <memory>
#include <vector>

#include "lab/results/record_header.hpp"
#include "lab/results/second_order_work_point.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// What the monitor tells as it watches. Any may be empty.
struct CollapseListener {
  /// A point of second-order work, as soon as its window is full.
  std::function<void(const SecondOrderWorkPoint&)> second_order_work;
  /// An onset was found, inside the limit surface or on it.
  std::function<void(const Event&)> happened;
};
using CollapseListeners = std::vector<CollapseListener>;

class CollapseMonitor {
 public:
  explicit CollapseMonitor(const RecordHeader& header, CollapseListeners listeners = {});
  ~CollapseMonitor();
  CollapseMonitor(const CollapseMonitor&) = delete;
  CollapseMonitor& operator=(const CollapseMonitor&) = delete;

  /// What is found by this state is known at the reading `now`, the last one taken so far; empty:
  /// only when the record had ended. Without it: at the state's own.
  void watch(const State& state, const std::optional<Moment>& now);
  void watch(const State& state);
  /// Of this state what the axis did is known, and nothing else need be: LossOfControl.
  void watch_axis(const State& state);
  /// States are missing here: no window reaches across, and no onset is placed in between.
  void interrupt();
  /// No more states will come; gives the verdict on all that was seen.
  Collapse finish();
  /// The verdict as it stands now, without closing the windows that are open.
  Collapse so_far() const;
  /// The verdict if nothing but a loss of control is believed: a specimen that ran away did so
  /// whatever became of its pore pressure, its volume and the valve.
  Collapse of_the_axis() const;
  /// The largest q seen in shear.
  std::optional<Instant> peak() const;
  /// Cycles of load, where there were any.
  std::optional<CyclicLoading> cyclic() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab

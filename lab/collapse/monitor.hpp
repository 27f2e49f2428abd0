#pragma once
// Watches the second-order work of the measured path, one state at a time, in constant memory, and
// says when, how and by which criteria the specimen lost sustainability (docs/theory.md).
#include <functional>
#include <memory>
#include <vector>

#include "lab/results/record_header.hpp"
#include "lab/results/second_order_work_point.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

class CollapseMonitor {
 public:
  explicit CollapseMonitor(const RecordHeader& header);
  ~CollapseMonitor();
  CollapseMonitor(const CollapseMonitor&) = delete;
  CollapseMonitor& operator=(const CollapseMonitor&) = delete;

  /// Called for each point of second-order work as soon as its window is full.
  std::function<void(const SecondOrderWorkPoint&)> on_point;
  /// Called at each event (onset found, strength came back, limit surface reached).
  std::function<void(const Event&)> on_event;

  void watch(const State& state);
  /// States are missing here: no window reaches across, and no onset is placed in between.
  void interrupt();
  /// No more states will come; gives the verdict on all that was seen.
  Collapse finish();
  /// The verdict as it stands now, without closing the windows that are open.
  Collapse so_far() const;
  /// The largest q seen in shear.
  std::optional<Instant> peak() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab

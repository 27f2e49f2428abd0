// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "lab/health/sensor_finding.hpp"
#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/second_order_work_point.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// What a session tells while it runs: to the recorder, a progress bar, a panel. Any may be empty.
struct SessionListener {
  std::function<void(const RecordHeader&)> started;  ///< once, before the first reading
  std::function<void(const Reading&, const State&)> scanned;
  std::function<void(const SecondOrderWorkPoint&)> second_order_work;
  std::function<void(const Event&)> happened;
  /// A sensor cannot be believed; also told as an event.
  std::function<void(const SensorFinding&)> doubted = {};
  /// A new forecast of the onset, told at the reading after which it was made.
  std::function<void(const Forecast&)> foreseen;
  /// Share done, in [0, 1]; about twenty times a second of clock time at most, and 1 at the end.
  std::function<void(double)> progressed;
};
using SessionListeners = std::vector<SessionListener>;

}  // namespace triax::lab

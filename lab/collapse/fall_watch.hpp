// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether the specimen runs away now, from readings as they come. The monitor's states have waited
// until nothing more can come to light about their sensors, and in a fall there is no time for
// that.
#include <optional>
#include <utility>

#include "lab/collapse/loss_of_control.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Takes what LossOfControl finds by the axis alone for a runaway once, at two readings in a row
/// within kPatience, the axial strain has gone by assessment_limits::kRunaway beyond where the
/// runaway began and, except at constant q, the load has not grown by half as much: dq dε < 0 on
/// the growing area. A spike is gone at the second of them, a step of the load that the specimen
/// carries has grown. Both are ignored, and the rates start again.
class FallWatch {
 public:
  static constexpr int kPatience = 10;  ///< readings
  static constexpr int kInARow = 2;

  explicit FallWatch(RecordHeader header) : header_(std::move(header)) {}

  /// Every state, in order. The burst, where it began, when it is known to be a runaway; told once
  /// a stage.
  std::optional<Finding> watch(const State& state);
  /// A sensor of the axis cannot be believed: rates are learned anew.
  void interrupt() { stage_.reset(); }

 private:
  void start(const StageInfo* stage);
  bool runs(const State& state) const;

  const RecordHeader header_;
  LossOfControl control_;
  std::optional<int> stage_;
  std::optional<int> told_;  ///< the stage of which it was told
  bool holds_q_ = false;
  int readings_ = 0, running_ = 0;  ///< since a burst was found; the latest that ran on
};

}  // namespace triax::lab

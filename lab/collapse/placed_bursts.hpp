// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a loss of control began, by the readings around it.
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/collapse/criterion.hpp"
#include "lab/collapse/fall_work.hpp"
#include "lab/collapse/loss_of_control.hpp"
#include "lab/measured/path_history.hpp"
#include "lab/measured/pore_fluid.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

struct PlacedBurst {
  std::int64_t of = 0;  ///< reading of the finding that it belongs to
  std::optional<StressInterval> interval;
  std::optional<Instant> fall;     ///< where second-order work vanished before a sudden one
  std::optional<Instant> control;  ///< where control was lost
  std::optional<FallWork> work;
};

/// The latest burst and an earlier one.
class PlacedBursts {
 public:
  /// The stage in which the burst came.
  struct Stage {
    double q = 0;                                 ///< at its first sample, Pa
    bool held = false, drained = false;           ///< q is held; the drainage is open
    std::optional<FluidCompliance> compliance{};  ///< of the pore fluid, where the valve is closed
    bool has_time = true;
  };
  /// Places what `control` found. `near`: the latest point of the path before it. Pre-condition:
  /// control.found().
  void place(const LossOfControl& control, const PathHistory& history,
             const std::optional<PathPoint>& near, const Stage& stage);
  /// Null where that one was not placed. Not to be kept across place().
  const PlacedBurst* of(const Finding& burst) const;

 private:
  std::vector<PlacedBurst> placed_;
};

}  // namespace triax::lab

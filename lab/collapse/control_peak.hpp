// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The control variable passes a peak: q under prescribed displacement; σ₁′ − σ₃′/R where the strain
// path dε₁ + 2R dε₃ = 0 is prescribed, whose second-order work is dε₁ (dσ₁′ − dσ₃′/R) (R = 1,
// undrained: q again); at constant q the volume turns to contraction while p' falls. Drained the
// volume is measured; with the valve closed the pore pressure is its gauge, C du = V dε_v with the
// compliance C of water and system, so that u passes a minimum.
#include <optional>

#include "lab/collapse/change_point.hpp"
#include "lab/collapse/criterion.hpp"

namespace triax::lab {

class ControlPeak : public CollapseCriterion {
 public:
  void start_stage(const StageInfo* stage) override;
  void add_point(const PathPoint& point, bool has_time) override;
  std::optional<Finding> finding() const override;
  std::string blind() const override;
  /// Whether the finding is that the volume, or its gauge, turned at held q.
  bool turned() const { return finding_ && turned_; }
  /// Where the pore pressure turned, if that is the finding.
  const std::optional<double>& turn_of_pore_pressure() const { return pore_turn_; }
  /// The same from a fit around it, where one was possible.
  void sharpen_turn(const Instant& turn) { sharper_turn_ = turn; }

 private:
  void check_peak(const PathPoint& smoothed, bool has_time);
  double control_variable(const PathPoint& point) const;
  void check_contraction(const PathPoint& point, bool has_time);

  bool looked_ = false;  ///< in any stage
  bool drained_ = false;
  bool load_controlled_ = false;
  bool held_q_ = false;
  double strain_path_R_ = 1;
  std::optional<PathPoint> top_;  ///< where the control variable was largest
  double largest_loss_ =
      0;  ///< its fall after a peak over q there: the peak that cost most is kept
  bool turned_ = false;
  ChangePoint contraction_;
  std::optional<PathPoint> before_;
  std::optional<double> pore_turn_;  ///< reading
  std::optional<Instant> sharper_turn_;
  double last_reading_ = -1;
  std::optional<Finding> finding_;
};

}  // namespace triax::lab

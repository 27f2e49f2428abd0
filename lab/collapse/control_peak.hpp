#pragma once
// The control variable passes a peak: q under prescribed displacement; at constant q the volume
// turns to contraction while p' falls. Drained the volume is measured; with the valve closed the
// pore pressure is its gauge, C du = V dε_v with the compliance C of water and system, so that u
// passes a minimum.
#include <optional>

#include "lab/collapse/change_point.hpp"
#include "lab/collapse/finding.hpp"
#include "lab/collapse/path_rates.hpp"

namespace triax::lab {

class ControlPeak {
 public:
  void start_stage(const StageInfo* stage);
  void add(const PathPoint& point, bool has_time);
  const std::optional<Finding>& finding() const { return finding_; }
  /// Where the pore pressure turned, if that is the finding.
  const std::optional<double>& turn_of_pore_pressure() const { return pore_turn_; }

 private:
  void check_q(const PathPoint& smoothed, bool has_time);
  void check_contraction(const PathPoint& point, bool has_time);

  bool drained_ = false;
  bool load_controlled_ = false;
  bool held_q_ = false;
  std::optional<PathPoint> top_;  ///< where |q| was largest
  double largest_loss_ = 0;       ///< share of q lost after a peak: the peak that cost most is kept
  ChangePoint contraction_;
  std::optional<PathPoint> before_;
  std::optional<double> pore_turn_;  ///< reading
  double last_reading_ = -1;
  std::optional<Finding> finding_;
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How near a specimen is to its onset while the test runs, in constant memory and from readings
// alone.
#include <optional>

#include "lab/results/outlook.hpp"
#include "lab/results/state.hpp"
#include "lab/warning/onset_forecast.hpp"

namespace triax::lab {

/// Watches the driven path and says `approaching`, `imminent` and, where somebody else found it,
/// `lost`; a level is left in one way only, by clear evidence, and lost is never left within its
/// stage.
///
///   approaching  less than kNear of η is left by the forecast, and less than kNearWork by the
///                normalised work, with a standard error below kUnsure, at three points in a row
///   imminent     at the present rate the onset may be (a standard error before its forecast)
///   kScans
///                scans away, or, under a load or held q, kSeconds or a fifth of the stage,
///                whichever is less, at two readings in a row
///   none         second-order work is positive for certain and the onset far, or none, at ten
///                points in a row
///
/// Neither level where the onset forecast lies on the limit surface, nor, where no limit is known,
/// above η = 1, which no loose sand reaches before it is lost.
class WarningLevels {
 public:
  explicit WarningLevels(bool has_time) : has_time_(has_time) {}

  void start_stage(const StageInfo* stage);
  /// The next point of the driven path.
  void add(const PathPoint& point);
  /// Every state in shear; `inside` says whether the onset that forecast() names lies inside the
  /// limit surface (empty: unknown). True where the level changed.
  bool look(const State& state, std::optional<bool> inside);
  /// It was lost, as a criterion found. True where that is news.
  bool lose();

  WarningLevel level() const { return level_; }
  /// η to come, with its sign; empty where there is no forecast.
  std::optional<double> eta_forecast() const;
  /// The forecast as it stands at that reading.
  std::optional<Outlook> outlook(const State& now) const;

 private:
  const std::optional<EtaForecast>& forecast() const { return forecast_.now(); }
  bool agrees(double share) const;
  bool is_far() const;
  double work_now() const;
  bool is_near() const;
  bool is_imminent() const;
  std::optional<LeftToOnset> left() const;
  std::optional<double> progress_left(double eta) const;

  bool has_time_;
  bool by_load_ = false, held_q_ = false, watches_ = false;
  OnsetForecast forecast_, by_work_{1.5};
  std::optional<PathPoint> point_;
  std::optional<State> first_, before_, state_;
  double eta_now_ = 0;      ///< |η| of the latest states, the lower of two
  double eta_before_ = 0;   ///< |η| of the one before
  int near_ = 0, far_ = 0;  ///< points in a row
  int soon_ = 0;            ///< states in a row
  WarningLevel level_ = WarningLevel::none;
};

}  // namespace triax::lab

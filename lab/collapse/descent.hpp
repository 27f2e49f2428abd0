// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Descents: stretches of the path along which second-order work is negative, with what they cost.
#include <optional>

#include "lab/collapse/change_point.hpp"
#include "lab/measured/path_rates.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// One stretch of negative second-order work.
struct Descent {
  PathPoint onset;  ///< where second-order work vanishes
  /// Readings between which it does: from the last window before the change into the first after
  /// it.
  double onset_low = 0, onset_high = 0;
  std::optional<PathPoint>
      sharper_onset;  ///< the same from a fit around it, where one was possible
  std::optional<StressInterval> interval;  ///< of the stresses at the better of the two
  /// When what it cost was first worth a loss, or it had lasted at held q; empty: never before the
  /// record ended.
  std::optional<Moment> noticed;
  PathPoint evidence;     ///< the first significantly negative point; if none, the nearest to it
  double q_lost = 0;      ///< fall of |q| while second-order work was negative, Pa: not unloading
  double q_least = 0;     ///< smallest |q| since the onset, Pa
  double q_regained = 0;  ///< largest |q| since that smallest one, Pa
  double axial_strain_last = 0;
  /// Strength was lost with the drainage open and the axis moved by displacement: failure of the
  /// skeleton at the peak that it has under that lateral stress.
  bool drained = false;
  bool by_displacement = false;  ///< a frame moved the axis, and q was free to fall
  bool closed = false;           ///< the valve was: volume changes with the pore pressure
  bool held_q = false;           ///< q was held
  /// What is strong later is another specimen: consolidated anew, or with water let in or out.
  bool settled = false;
  bool ended = false;      ///< with its stage, or because
  bool came_back = false;  ///< second-order work turned positive again

  const PathPoint& best_onset() const { return sharper_onset ? *sharper_onset : onset; }
  /// Share of the strength at the onset that was lost, 0 to 1.
  double strength_loss() const;
  /// How much of the fall to the smallest q has come back since; 1 and more if all of it.
  double strength_regained() const;
};

class DescentTracker {
 public:
  /// How a stage is sheared.
  struct Conditions {
    bool drained = false, by_displacement = false;  ///< see Descent
    bool another_specimen = false;                  ///< than before
    bool closed = false, held_q = false;            ///< see Descent
  };
  void add(const PathPoint& point);
  /// The descent that cost most strength so far; a descent that begins before the strength lost in
  /// the one before has half come back is that one's continuation.
  const std::optional<Descent>& worst() const { return worst_; }
  /// The descent under way or just ended.
  const std::optional<Descent>& latest() const { return latest_; }
  /// Gives the latest descent a sharper onset.
  void sharpen(const PathPoint& onset, const std::optional<StressInterval>& interval);
  /// The latest is a loss: that is known now.
  void notice(const std::optional<Moment>& now);
  /// A new stage begins: no onset may be placed before it.
  void start_stage(const Conditions& conditions);

 private:
  void start_over(const PathPoint& point);
  void keep_evidence(const PathPoint& point);
  void open(const PathPoint& point);
  void follow(const PathPoint& point);
  void keep_worst();

  ChangePoint turn_negative_, turn_positive_;
  std::optional<PathPoint> before_;  ///< last point before the possible change
  std::optional<PathPoint> after_;   ///< first one past it
  std::optional<PathPoint> evidence_;
  std::optional<Descent> latest_, worst_;
  std::optional<PathPoint> previous_;
  double q_lost_ = 0;  ///< since after_
  Conditions conditions_;
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Relaxation: the drive stands, and the force falls by itself. No strength is lost by that.
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/measured/path_rates.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Tells points of the path at which the axis is driven from those at which it rests, in constant
/// memory. It rests where |q| falls while the axial strain advances at less than kRests of the rate
/// of the stage so far (a second where there is time, else a reading), beyond its scatter, and does
/// not turn back, which is unloading, and p' changes by no more than q does: at held q, where p' is
/// lowered, nothing rests. Points that are slower than kSlow are held back, kHeld at most, until
/// those that follow decide; where the drive only goes slower they are judged after all. Not where
/// q or a load is prescribed.
class AxisRest {
 public:
  static constexpr double kSlow = 0.5, kResumes = 0.2, kRests = 0.1;
  static constexpr std::size_t kHeld = 64;
  /// q that goes on to this fraction of what it was, with the other sign, is driven.
  static constexpr double kReversed = 0.1;

  struct Fall {
    std::int64_t reading = 0;  ///< where the rest began
    double share = 0;          ///< of |q| there
    double q = 0;              ///< there
  };

  void start_stage(const StageInfo* stage, bool has_time);
  /// The points that are to be judged now: none while in doubt or at rest, later perhaps several.
  /// Valid until the next call.
  const std::vector<PathPoint>& add(const PathPoint& point);
  /// The stage is over: what was in doubt is to be judged.
  const std::vector<PathPoint>& finish();
  /// The first rest during which |q| fell by more than relaxation explains
  /// (assessment_limits::kRelaxation): what was read as rest may be a displacement transducer that
  /// is stuck, and nothing is known of what followed.
  const std::optional<Fall>& unlikely() const { return unlikely_; }

 private:
  double lapse(const PathPoint& from, const PathPoint& to) const;
  double rate(const PathPoint& from, const PathPoint& to) const;
  void take(const PathPoint& point);
  void release();
  /// Of the strain since it went slow, to where the specimen is sheared.
  double advance(const PathPoint& point) const;
  bool has_stopped(const PathPoint& point) const;
  void doubt(const PathPoint& point, double now);
  void watch_fall(const PathPoint& point);
  void watch_reversal(const PathPoint& point);

  bool looks_ = false, has_time_ = true, rests_ = false;
  std::optional<PathPoint> before_;     ///< the last one, of whatever kind
  std::optional<PathPoint> slow_from_;  ///< since when it is slower than kResumes
  double typical_ = 0;                  ///< rate while driven
  int driven_ = 0;
  double q_at_stop_ = 0;
  bool stopped_under_load_ = false;
  std::int64_t stopped_at_ = 0;
  std::vector<PathPoint> held_, out_;
  std::optional<Fall> unlikely_;
};

}  // namespace triax::lab

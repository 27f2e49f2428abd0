// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/axis_rest.hpp"

#include <algorithm>
#include <cmath>

#include "lab/measured/assessment_limits.hpp"

namespace triax::lab {
namespace {

constexpr int kKnown = 4;        ///< points that make a rate
constexpr int kMemory = 64;      ///< points that the usual rate remembers
constexpr double kDead = 0.002;  ///< of the usual rate: the strain does not move at all

// The middle of the window itself: what was smoothed over it begins to stand before the drive does.
double middle(const PathPoint& point, PathSample::Signal signal) {
  return point.middle.signal[signal];
}

double strength(const PathPoint& point) { return std::fabs(middle(point, PathSample::q)); }

bool falls(const PathPoint& from, const PathPoint& to) {
  const auto change = [&](PathSample::Signal signal) {
    return std::fabs(middle(to, signal) - middle(from, signal));
  };
  return strength(to) < strength(from) && change(PathSample::p_eff) <= change(PathSample::q);
}

}  // namespace

void AxisRest::start_stage(const StageInfo* stage, bool has_time) {
  const auto unlikely = unlikely_;
  *this = AxisRest();
  unlikely_ = unlikely;
  has_time_ = has_time;
  looks_ = !stage || stage->control == AxialControl::displacement ||
           stage->control == AxialControl::unknown;
}

double AxisRest::lapse(const PathPoint& from, const PathPoint& to) const {
  const auto along = has_time_ ? PathSample::progress : PathSample::reading;
  return middle(to, along) - middle(from, along);
}

double AxisRest::rate(const PathPoint& from, const PathPoint& to) const {
  const double dt = lapse(from, to);
  return dt > 0 ? std::fabs(middle(to, PathSample::axial_strain) -
                            middle(from, PathSample::axial_strain)) /
                      dt
                : typical_;
}

void AxisRest::take(const PathPoint& point) {
  if (before_) {
    const double weight = 1.0 / std::min(++driven_, kMemory);
    typical_ += weight * (rate(*before_, point) - typical_);
  }
  out_.push_back(point);
}

void AxisRest::release() {
  out_.insert(out_.end(), held_.begin(), held_.end());
  held_.clear();
  slow_from_.reset();
}

double AxisRest::advance(const PathPoint& point) const {
  const auto strain = PathSample::axial_strain;
  return std::copysign(1.0, slow_from_->q) * (middle(point, strain) - middle(*slow_from_, strain));
}

/// From where it went slow the strain did not advance, as far as its scatter lets tell.
bool AxisRest::has_stopped(const PathPoint& point) const {
  if (!slow_from_ || !falls(*slow_from_, point)) return false;
  const double expected = typical_ * lapse(*slow_from_, point);
  // A parabola's value at the middle of a window has a third of the variance of its middle block.
  const double scatter = std::sqrt(3 * (point.strain_variance + slow_from_->strain_variance));
  const bool unloads = advance(point) < -std::max(3 * scatter, kDead * expected);
  return !unloads && advance(point) < kRests * expected && expected > 4 * scatter;
}

void AxisRest::watch_fall(const PathPoint& point) {
  const double share = 1 - strength(point) / std::fabs(q_at_stop_);
  const bool dead = std::fabs(advance(point)) < kDead * typical_ * lapse(*slow_from_, point);
  if (!(share > assessment_limits::kRelaxation) || !dead || !stopped_under_load_) return;
  if (unlikely_ && unlikely_->reading != stopped_at_) return;
  unlikely_ = Fall{stopped_at_, share, q_at_stop_};
}

void AxisRest::watch_reversal(const PathPoint& point) {
  if (unlikely_ && middle(point, PathSample::q) / unlikely_->q < -kReversed) unlikely_.reset();
}

void AxisRest::doubt(const PathPoint& point, double now) {
  if (held_.empty()) {
    q_at_stop_ = middle(*before_, PathSample::q);
    stopped_under_load_ =
        strength(*before_) > assessment_limits::kMinRatio * middle(*before_, PathSample::p_eff);
    stopped_at_ = std::llround(before_->reading);
  }
  if (now >= kResumes * typical_)
    slow_from_.reset();
  else if (!slow_from_)
    slow_from_ = before_;
  held_.push_back(point);
  if (has_stopped(point)) {
    rests_ = true;
    held_.clear();
    slow_from_ = point;  // from here on the strain stands, if it does
  } else if (held_.size() >= kHeld) {
    release();
    driven_ = 0;  // it goes slower from now on
  }
}

const std::vector<PathPoint>& AxisRest::add(const PathPoint& point) {
  out_.clear();
  watch_reversal(point);
  const bool known = looks_ && driven_ >= kKnown && before_;
  const double now = known ? rate(*before_, point) : 0;
  if (rests_ && now < kResumes * typical_) {
    watch_fall(point);
  } else if (rests_) {
    rests_ = false;
    slow_from_.reset();
    driven_ = 0;  // the drive may go on at another rate
    out_.push_back(point);
    out_.back().after_rest = true;
  } else if (known && now < kSlow * typical_ && falls(*before_, point)) {
    doubt(point, now);
  } else {
    release();
    take(point);
  }
  before_ = point;
  return out_;
}

const std::vector<PathPoint>& AxisRest::finish() {
  out_.clear();
  release();
  return out_;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/descent.hpp"

#include <algorithm>

#include "lab/measured/assessment_limits.hpp"

namespace triax::lab {
namespace {

/// The point where second-order work vanishes between `a`, where it is positive, and `b`. Between
/// two neighbouring readings it is the one with the larger q: undrained, work vanishes at the peak
/// of q, and a parabola through seven readings leans towards the flatter side of a sharp peak. Not
/// so where the pore fluid is compressed (`closed`): work vanishes before q has its peak.
PathPoint zero_crossing(const PathPoint& a, const PathPoint& b, bool closed) {
  if (!closed && a.shortest_window() && b.shortest_window() && b.reading - a.reading < 1.5) {
    const PathPoint first = unsmoothed(a), second = unsmoothed(b);
    return first.strength() >= second.strength() ? first : second;
  }
  const double fall = a.work.normalised - b.work.normalised;
  const double share = fall > 0 ? std::clamp(a.work.normalised / fall, 0.0, 1.0) : 0.0;
  PathPoint p = share < 0.5 ? a : b;
  const auto between = [share](double x, double y) { return x + share * (y - x); };
  p.reading = between(a.reading, b.reading);
  p.progress = between(a.progress, b.progress);
  p.q = between(a.q, b.q);
  p.p_eff = between(a.p_eff, b.p_eff);
  p.axial_strain = between(a.axial_strain, b.axial_strain);
  p.volumetric_strain = between(a.volumetric_strain, b.volumetric_strain);
  p.pore_pressure = between(a.pore_pressure, b.pore_pressure);
  return p;
}

/// True if from `a` to `b` strength worth the name was lost and the finite increments themselves
/// give negative second-order work beyond three standard errors. A few readings may be too few for
/// sure slopes, while what was lost is plain.
bool falls_between(const PathPoint& a, const PathPoint& b) {
  if (a.strength() - b.strength() < assessment_limits::kLossOfStrength * a.strength()) return false;
  const PathStep step{b.q - a.q, b.p_eff - a.p_eff, b.axial_strain - a.axial_strain,
                      b.volumetric_strain - a.volumetric_strain};
  const double error = direction_error(step, a.stress_variance + b.stress_variance,
                                       a.strain_variance + b.strain_variance);
  return normalised_second_order_work(step) < -3 * error;
}

}  // namespace

double Descent::strength_loss() const {
  return onset.strength() > 0 ? std::clamp(q_lost / onset.strength(), 0.0, 1.0) : 0.0;
}

double Descent::strength_regained() const {
  const double lost = onset.strength() - q_least;
  return lost > 0 ? (q_regained - q_least) / lost : 0.0;
}

void DescentTracker::start_stage(const Conditions& conditions) {
  conditions_ = conditions;
  turn_negative_.clear();
  turn_positive_.clear();
  before_.reset();
  after_.reset();
  evidence_.reset();
  previous_.reset();
  q_lost_ = 0;
  if (latest_) latest_->ended = true;
  for (auto* descent : {&latest_, &worst_})
    if (*descent) (*descent)->settled = (*descent)->settled || conditions.another_specimen;
}

void DescentTracker::add(const PathPoint& point) {
  const double advance = previous_ ? point.reading - previous_->reading : 1.0;
  const double weight = std::min(1.0, advance / static_cast<double>(point.window_readings));
  const bool resolved = point.normalised_error <= ChangePoint::kUseless;
  const bool follows = previous_ && !point.after_rest;
  const double strength_before = (follows ? *previous_ : point).strength();
  previous_ = point;
  if (resolved && point.work.normalised < 0) q_lost_ += strength_before - point.strength();

  for (auto* descent : {&latest_, &worst_})
    if (*descent && !(*descent)->settled)
      (*descent)->q_regained = std::max((*descent)->q_regained, point.strength());

  if (latest_ && !latest_->ended) {
    turn_positive_.add(-point.work.normalised, point.normalised_error, weight);
    follow(point);
    if (turn_positive_.found()) {
      latest_->ended = latest_->came_back = true;
      keep_worst();
      start_over(point);
    }
    return;
  }
  if (!resolved) return;
  // Where strength grew by as much as would count as a loss, nothing was descending before.
  if (after_ && point.strength() > (1 + assessment_limits::kLossOfStrength) * after_->strength())
    turn_negative_.clear();
  if (turn_negative_.add(point.work.normalised, point.normalised_error, weight)) {
    start_over(point);
    return;
  }
  if (!after_) after_ = point;
  keep_evidence(point);
  if (turn_negative_.found() || (turn_negative_.lasted() && falls_between(*after_, point)))
    open(point);
}

void DescentTracker::start_over(const PathPoint& point) {
  turn_negative_.clear();
  before_ = point;
  after_.reset();
  evidence_.reset();
  q_lost_ = 0;
}

void DescentTracker::keep_evidence(const PathPoint& point) {
  const auto significance = [](const PathPoint& p) {
    return -p.work.normalised / p.normalised_error;
  };
  if (evidence_ && evidence_->significantly_negative()) return;
  if (!evidence_ || significance(point) > significance(*evidence_)) evidence_ = point;
}

void DescentTracker::open(const PathPoint& point) {
  turn_positive_.clear();
  const PathPoint onset = before_ ? zero_crossing(*before_, *after_, conditions_.closed) : *after_;
  const bool continues = latest_ && !latest_->settled &&
                         onset.strength() < latest_->onset.strength() &&
                         latest_->strength_regained() < 0.5;
  if (continues) {
    latest_->ended = latest_->came_back = false;
  } else {
    const PathPoint& first = before_ ? *before_ : *after_;
    const auto reach = [](const PathPoint& p) {
      return p.shortest_window() ? 1.0 : static_cast<double>(p.window_readings) / 4;
    };
    latest_ = Descent{.onset = onset,
                      .onset_low = first.reading - reach(first),
                      .onset_high = after_->reading + reach(*after_),
                      .evidence = evidence_.value_or(point),
                      .q_lost = 0,
                      .q_least = onset.strength(),
                      .q_regained = onset.strength(),
                      .axial_strain_last = onset.axial_strain,
                      .drained = conditions_.drained,
                      .by_displacement = conditions_.by_displacement,
                      .closed = conditions_.closed,
                      .held_q = conditions_.held_q};
  }
  follow(point);
}

void DescentTracker::follow(const PathPoint& point) {
  latest_->q_lost += q_lost_;
  q_lost_ = 0;
  if (point.strength() < latest_->q_least)
    latest_->q_least = latest_->q_regained = point.strength();
  latest_->axial_strain_last = point.axial_strain;
  keep_worst();
}

void DescentTracker::sharpen(const PathPoint& onset,
                             const std::optional<StressInterval>& interval) {
  latest_->sharper_onset = onset;
  latest_->interval = interval;
  keep_worst();
}

void DescentTracker::notice(const std::optional<Moment>& now) {
  if (!latest_ || latest_->noticed) return;
  latest_->noticed = now;
  keep_worst();
}

void DescentTracker::keep_worst() {
  const bool same = worst_ && worst_->onset.reading == latest_->onset.reading;
  if (same || !worst_ || latest_->strength_loss() >= worst_->strength_loss()) worst_ = latest_;
}

}  // namespace triax::lab

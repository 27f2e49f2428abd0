// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/warning_levels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::lab {
namespace {

constexpr double kNear = 0.25, kClose = 0.15;  ///< share of η that is left
constexpr double kWithin = 0.35;               ///< likewise, of an onset that may be imminent
constexpr double kFar = 0.45;                  ///< likewise, from which nothing is ahead
constexpr double kUnsure = 0.12, kUnsureSoon = 0.15;  ///< standard error of what says nothing, of η
constexpr double kVague = 0.4;    ///< likewise, of one that is not worth telling
constexpr double kHighest = 1.0;  ///< |η| at an onset where no limit is known
/// Fraction of η that the stage must have covered, and largest standard error of normalised work
/// along a strain path.
constexpr double kSeen = 0.06, kUnsureWork = 0.1;
/// Of −dp′/dx at the onset over what it is now: from which it is an onset, and none.
constexpr double kFalls = 0.95, kFallsLess = 0.8, kTurns = 0.7;
/// Normalised work at most: near an onset, and near one though p′ falls less and less.
constexpr double kWorkNear = 0.4, kWorkNearLess = 0.25;
/// Likewise, soon before an onset: by a load, though p′ falls less, within kScans; by displacement
/// also once the forecast may be passed.
constexpr double kWorkLoad = 0.33, kWorkLess = 0.185, kWorkScans = 0.5, kWorkFrame = 0.14;
/// At held q, by the share of η that is left: below which a hunting pressure may bring the fall.
constexpr double kPerturbed = 0.1;
/// Fraction of the limit surface by which an onset lies below it: from there on work counts as it
/// is. For an onset on the limit itself no work is low.
constexpr double kRoom = 0.45;
constexpr double kSofter = 0.58, kSoft = 0.55;  ///< dy/dx at held q over its largest: near, soon
constexpr int kNearLooks = 3, kSoonLooks = 2, kFarLooks = 5;  ///< in a row
constexpr int kFew = 64;                                      ///< readings of the stage
constexpr double kSure = 0.03;                                ///< standard error of normalised work
constexpr double kScans = 5, kScansOnPath = 3, kSeconds = 120, kShareOfStage = 0.2;
constexpr double kScansKnown = 2, kSureKnown = 0.06;  ///< where earlier tests know of the onset
constexpr double kAtMost = 4;  ///< of such a time, until the onset as it is forecast

double progress_of(const State& s, bool has_time) { return has_time ? s.time_s : s.strain.axial; }
double lapse(const LeftToOnset& left) { return left.time_s.value_or(left.value); }

}  // namespace

void WarningLevels::start_stage(const StageInfo* stage, const SpecimenVolume& volume) {
  OnsetForecast forecast = std::move(forecast_);
  *this = WarningLevels(has_time_);
  forecast_ = std::move(forecast);
  forecast_.start_stage(stage, has_time_, volume);
}

bool WarningLevels::add(const State& state) {
  if (forecast_.control() == DrivenPath::Control::none) return false;
  if (!first_) first_ = state;
  before_ = std::exchange(state_, state);
  const double eta = std::fabs(state.eta());
  eta_now_ = before_ ? std::min(eta, eta_before_) : eta;
  eta_before_ = eta;
  is_new_ = forecast_.add(state);
  return is_new_;
}

bool WarningLevels::is_near() const {
  const auto& f = forecast();
  if (!f || f->error > kUnsure * f->eta || f->covered < kSeen) return false;
  if (f->by == AxialControl::constant_q)
    return f->left() <= kClose && f->stiffness + f->stiffness_error <= kSofter;
  if (f->left() > kNear) return false;
  return (f->work <= room_ * kWorkNear && f->fall >= kFalls) ||
         (f->work <= room_ * kWorkNearLess && f->fall >= kFallsLess);
}

/// Looks at neighbouring readings are hardly more evidence than one.
double WarningLevels::count_look(bool shows, double in_row) const {
  if (!shows) return 0;
  return in_row > 0 ? in_row + forecast_.new_evidence() : 1;
}

bool WarningLevels::is_far() const {
  const auto& f = forecast();
  if (!forecast_.clear()) return false;
  return !f || f->left() > kFar || f->error > 2 * kUnsure * f->eta || f->fall < kTurns;
}

/// What is left of what drives the stage until η, and the time at the present rate.
std::optional<LeftToOnset> WarningLevels::left(double eta) const {
  EtaForecast f = *forecast();
  f.now = std::max(f.now, std::min(eta_now_, f.eta));
  LeftToOnset left{.quantity = Quantity::axial_strain, .value = f.way_to(eta), .time_s = {}};
  if (f.by == AxialControl::load) left.quantity = Quantity::deviator_stress;
  if (f.by == AxialControl::constant_q) left.quantity = Quantity::mean_effective_stress;
  if (!std::isfinite(left.value)) return std::nullopt;
  if (!has_time_) return left;
  const auto rate = forecast_.rate();
  if (!rate) return std::nullopt;
  left.time_s = left.value / *rate;
  return left;
}

bool WarningLevels::is_imminent() const {
  const EtaForecast& f = *forecast();
  if (f.error > kUnsureSoon * f.eta || f.left() > kWithin || !before_) return false;
  if (may_come()) return true;
  return f.by == AxialControl::constant_q ? is_imminent_at_held_q() : is_imminent_on_path();
}

/// Earlier tests of the sand went through as little work, and carried on.
bool WarningLevels::carried_on_there() const {
  const auto least = forecast_.carried_on();
  return least && forecast()->work + 2 * forecast()->work_error + kSure >= *least;
}

/// Where earlier tests agree that there is an onset it needs no stiffness that is nearly gone: it
/// may come within the next scans.
bool WarningLevels::may_come() const {
  const EtaForecast& f = *forecast();
  const double step = std::fabs(state_->eta()) - std::fabs(before_->eta());
  return f.by_earlier && forecast_.earlier_agree() && f.error <= kSureKnown * f.eta &&
         f.fall >= kTurns && eta_now_ + kScansKnown * std::max(step, 0.0) >= f.eta - f.error;
}

/// Not when it will be, but when it may be: `left` counts to a standard error before the forecast.
bool WarningLevels::is_imminent_on_path() const {
  const EtaForecast& f = *forecast();
  if (f.work_error > kUnsureWork) return false;
  const double may_be = f.eta - f.error;
  if (f.by != AxialControl::load)
    return f.fall >= kFalls && ((f.work <= room_ * kWorkFrame && f.left() <= kClose) ||
                                (f.work - f.work_error <= room_ * kWorkLess && eta_now_ >= may_be));
  if (f.work <= room_ * kWorkLess) return f.fall >= kFallsLess;
  return f.fall >= kFalls && (f.work <= room_ * kWorkLoad ||
                              (f.work <= room_ * kWorkScans && within_scans(may_be, kScansOnPath)));
}

bool WarningLevels::within_scans(double eta, double scans) const {
  const auto to = left(eta);
  return to && lapse(*to) <= scans * since(*before_);
}

bool WarningLevels::is_imminent_at_held_q() const {
  const EtaForecast& f = *forecast();
  if (f.covered < kSeen) return false;
  if (f.work <= kPerturbed && f.left() <= kPerturbed) return true;
  const auto first = left(f.eta - f.error), at_last = left(f.eta);
  if (f.stiffness + f.stiffness_error > kSoft || !first || !at_last) return false;
  const double share = kShareOfStage * since(*first_);
  const double soon =
      std::max(kScans * since(*before_), has_time_ ? std::min(kSeconds, share) : share);
  return lapse(*first) <= soon && lapse(*at_last) <= kAtMost * soon;
}

double WarningLevels::since(const State& s) const {
  return std::fabs(progress_of(*state_, has_time_) - progress_of(s, has_time_));
}

/// Among few readings the next may be after the fall.
bool WarningLevels::is_last_chance() const {
  const EtaForecast& f = *forecast();
  return forecast_.readings() <= kFew && f.work_error <= kSure && within_scans(f.eta, 1);
}

bool WarningLevels::look(std::optional<bool> inside, double below_limit) {
  if (level_ == WarningLevel::lost) return false;
  room_ = std::clamp(below_limit / kRoom, 0.0, 1.0);
  if (is_new_) {
    near_ = count_look(is_near(), near_);
    far_ = count_look(is_far(), far_);
  }
  const WarningLevel was = level_;
  const bool points = forecast() && inside != false && (inside || forecast()->eta < kHighest) &&
                      !carried_on_there();
  if (is_new_ && (forecast() || forecast_.clear())) {
    soon_ = count_look(points && is_imminent(), soon_);
    if (soon_ > 0 && is_last_chance()) soon_ = kSoonLooks;
  }
  if (level_ == WarningLevel::none && points && near_ >= kNearLooks)
    level_ = WarningLevel::approaching;
  // Past the onset nothing is ahead any more, and nothing is taken back.
  if (inside == false || far_ >= kFarLooks) level_ = WarningLevel::none;
  if (points && soon_ >= kSoonLooks) level_ = WarningLevel::imminent;
  return level_ != was;
}

bool WarningLevels::lose() {
  return std::exchange(level_, WarningLevel::lost) != WarningLevel::lost;
}

std::optional<double> WarningLevels::eta_forecast() const {
  if (!forecast() || forecast()->error > kVague * forecast()->eta) return std::nullopt;
  return forecast_.in_extension() ? -forecast()->eta : forecast()->eta;
}

std::optional<Forecast> WarningLevels::current_forecast(const State& now) const {
  const auto eta = eta_forecast();
  if (!eta) return std::nullopt;
  // An onset that was not passed lies ahead.
  double low = forecast()->eta - kOf90 * forecast()->error;
  if (forecast()->eta > eta_now_) low = std::max(low, eta_now_);
  const double high = forecast()->eta + kOf90 * forecast()->error_above;
  Forecast current{.reading = now.reading,
                   .time_s = {},
                   .eta = *eta,
                   .eta_low = low,
                   .eta_high = high,
                   .left = left(forecast()->eta)};
  if (has_time_) current.time_s = now.time_s;
  if (*eta < 0) current.eta_low = -high, current.eta_high = -low;
  return current;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/warning_levels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/warning/warning_limits.hpp"

namespace triax::lab {
namespace {

namespace limits = warning_limits;

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
  if (!f || f->error > limits::kUnsure * f->eta || f->covered < limits::kSeen) return false;
  if (f->by == AxialControl::constant_q)
    return f->left() <= limits::kClose && f->stiffness + f->stiffness_error <= limits::kSofter;
  if (f->left() > limits::kNear) return false;
  return (f->work <= room_ * limits::kWorkNear && f->fall >= limits::kFalls) ||
         (f->work <= room_ * limits::kWorkNearLess && f->fall >= limits::kFallsLess);
}

/// Looks at neighbouring readings are hardly more evidence than one.
double WarningLevels::count_look(bool shows, double in_row) const {
  if (!shows) return 0;
  return in_row > 0 ? in_row + forecast_.new_evidence() : 1;
}

bool WarningLevels::is_far() const {
  const auto& f = forecast();
  if (!forecast_.clear()) return false;
  return !f || f->left() > limits::kFar || f->error > 2 * limits::kUnsure * f->eta ||
         f->fall < limits::kTurns;
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
  if (f.error > limits::kUnsureSoon * f.eta || f.left() > limits::kWithin || !before_) return false;
  if (may_come()) return true;
  return f.by == AxialControl::constant_q ? is_imminent_at_held_q() : is_imminent_on_path();
}

/// Earlier tests of the sand went through as little work, and carried on.
bool WarningLevels::carried_on_there() const {
  const auto least = forecast_.carried_on();
  return least && forecast()->work + 2 * forecast()->work_error + limits::kSure >= *least;
}

/// Where earlier tests agree that there is an onset it needs no stiffness that is nearly gone: it
/// may come within the next scans.
bool WarningLevels::may_come() const {
  const EtaForecast& f = *forecast();
  const double step = std::fabs(state_->eta()) - std::fabs(before_->eta());
  return f.by_earlier && forecast_.earlier_agree() && f.error <= limits::kSureKnown * f.eta &&
         f.fall >= limits::kTurns &&
         eta_now_ + limits::kScansKnown * std::max(step, 0.0) >= f.eta - f.error;
}

/// Not when it will be, but when it may be: `left` counts to a standard error before the forecast.
bool WarningLevels::is_imminent_on_path() const {
  const EtaForecast& f = *forecast();
  if (f.work_error > limits::kUnsureWork) return false;
  const double may_be = f.eta - f.error;
  if (f.by != AxialControl::load)
    return f.fall >= limits::kFalls &&
           ((f.work <= room_ * limits::kWorkFrame && f.left() <= limits::kClose) ||
            (f.work - f.work_error <= room_ * limits::kWorkLess && eta_now_ >= may_be));
  if (f.work <= room_ * limits::kWorkLess) return f.fall >= limits::kFallsLess;
  return f.fall >= limits::kFalls &&
         (f.work <= room_ * limits::kWorkLoad ||
          (f.work <= room_ * limits::kWorkScans && within_scans(may_be, limits::kScansOnPath)));
}

bool WarningLevels::within_scans(double eta, double scans) const {
  const auto to = left(eta);
  return to && lapse(*to) <= scans * since(*before_);
}

bool WarningLevels::is_imminent_at_held_q() const {
  const EtaForecast& f = *forecast();
  if (f.covered < limits::kSeen) return false;
  if (f.work <= limits::kPerturbed && f.left() <= limits::kPerturbed) return true;
  const auto first = left(f.eta - f.error), at_last = left(f.eta);
  if (f.stiffness + f.stiffness_error > limits::kSoft || !first || !at_last) return false;
  const double share = limits::kPartOfStage * since(*first_);
  const double soon = std::max(limits::kScans * since(*before_),
                               has_time_ ? std::min<double>(limits::kSeconds, share) : share);
  return lapse(*first) <= soon && lapse(*at_last) <= limits::kAtMost * soon;
}

double WarningLevels::since(const State& s) const {
  return std::fabs(progress_of(*state_, has_time_) - progress_of(s, has_time_));
}

/// Among few readings the next may be after the fall.
bool WarningLevels::is_last_chance() const {
  const EtaForecast& f = *forecast();
  return forecast_.readings() <= limits::kFew.count() && f.work_error <= limits::kSure &&
         within_scans(f.eta, 1);
}

bool WarningLevels::look(std::optional<bool> inside, double below_limit) {
  if (level_ == WarningLevel::lost) return false;
  room_ = std::clamp(below_limit / limits::kRoom, 0.0, 1.0);
  if (is_new_) {
    near_ = count_look(is_near(), near_);
    far_ = count_look(is_far(), far_);
  }
  const WarningLevel was = level_;
  const bool points = forecast() && inside != false &&
                      (inside || forecast()->eta < limits::kHighest) && !carried_on_there();
  if (is_new_ && (forecast() || forecast_.clear())) {
    soon_ = count_look(points && is_imminent(), soon_);
    if (soon_ > 0 && is_last_chance()) soon_ = limits::kSoonLooks;
  }
  if (level_ == WarningLevel::none && points && near_ >= limits::kNearLooks)
    level_ = WarningLevel::approaching;
  // Past the onset nothing is ahead any more, and nothing is taken back.
  if (inside == false || far_ >= limits::kFarLooks) level_ = WarningLevel::none;
  if (points && soon_ >= limits::kSoonLooks) level_ = WarningLevel::imminent;
  return level_ != was;
}

bool WarningLevels::lose() {
  return std::exchange(level_, WarningLevel::lost) != WarningLevel::lost;
}

std::optional<double> WarningLevels::eta_forecast() const {
  if (!forecast() || forecast()->error > limits::kVague * forecast()->eta) return std::nullopt;
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

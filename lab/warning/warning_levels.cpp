// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/warning_levels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::lab {
namespace {

constexpr double kNear = 0.35;    ///< share of η that is left
constexpr double kFar = 0.45;     ///< likewise, from which nothing is ahead
constexpr double kUnsure = 0.12;  ///< standard error of a forecast that says nothing, of η
/// Of −dp′/dx at the onset over what it is now: from which it is an onset, soon one, and none.
constexpr double kFalls = 0.8, kFallsSoon = 0.88, kTurns = 0.7;
/// Normalised work at held q below which a hunting pressure may bring the fall.
constexpr double kPerturbed = 0.1, kSoftPerturbed = 0.3;
/// dy/dx over the largest of the stage, at most: ahead of an onset, and soon before it under a
/// load, at held q and by displacement.
constexpr double kSofter = 0.65, kSofterHeld = 0.58, kSoftLoad = 0.4, kSoftHeld = 0.55,
                 kSoftFrame = 0.2;
constexpr double kVague = 0.4;    ///< likewise, of one that is not worth telling
constexpr double kHighest = 1.0;  ///< |η| at an onset where no limit is known
constexpr int kNearLooks = 3, kSoonStates = 2, kFarLooks = 10;  ///< in a row
constexpr double kScans = 5, kSeconds = 120, kShareOfStage = 0.2, kShareOfFrame = 0.05;
constexpr double kAtMost = 4;    ///< of such a time, until the onset as it is forecast
constexpr double kOf90 = 1.645;  ///< standard errors on each side of a 90 % interval

double progress_of(const State& s, bool has_time) { return has_time ? s.time_s : s.strain.axial; }

}  // namespace

void WarningLevels::start_stage(const StageInfo* stage) {
  *this = WarningLevels(has_time_);
  by_force_ =
      stage && (stage->control == AxialControl::load || stage->control == AxialControl::constant_q);
  forecast_.start_stage(stage, has_time_);
}

bool WarningLevels::add(const State& state) {
  if (forecast_.control() == DrivenPath::Control::none) return false;
  if (!first_) first_ = state;
  before_ = std::exchange(state_, state);
  const double eta = std::fabs(state.eta());
  eta_now_ = before_ ? std::min(eta, eta_before_) : eta;
  eta_before_ = eta;
  if (!forecast_.add(state)) return false;
  near_ = is_near() ? near_ + 1 : 0;
  far_ = is_far() ? far_ + 1 : 0;
  return true;
}

bool WarningLevels::is_near() const {
  const auto& f = forecast();
  return f && f->left() <= kNear && f->error <= kUnsure * f->eta && f->fall >= kFalls &&
         f->stiffness <= (f->by == AxialControl::constant_q ? kSofterHeld : kSofter);
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

/// Soft enough for a fall, within the error; a load runs into it, a frame walks.
bool WarningLevels::is_soft() const {
  const EtaForecast& f = *forecast();
  if (f.by == AxialControl::load) return f.stiffness <= kSoftLoad;
  if (f.by == AxialControl::constant_q) return f.stiffness + f.stiffness_error <= kSoftHeld;
  return f.stiffness - f.stiffness_error <= kSoftFrame;
}

bool WarningLevels::is_imminent() const {
  const EtaForecast& f = *forecast();
  if (f.error > kUnsure * f.eta || f.fall < kFallsSoon || !is_soft() || !before_) return false;
  // Not when it will be, but when it may be.
  const double may_be = f.eta - f.error;
  if (!by_force_ && eta_now_ >= may_be) return true;
  if (near_ < kNearLooks) return false;
  if (f.work <= kPerturbed && f.stiffness <= kSoftPerturbed) return true;
  const auto first = left(may_be), at_last = left(f.eta);
  if (!first || !at_last) return false;
  const auto since = [&](const State& s) {
    return std::fabs(progress_of(*state_, has_time_) - progress_of(s, has_time_));
  };
  const double share = (by_force_ ? kShareOfStage : kShareOfFrame) * since(*first_);
  const double soon =
      std::max(kScans * since(*before_), has_time_ ? std::min(kSeconds, share) : share);
  const auto lapse = [](const LeftToOnset& l) { return l.time_s.value_or(l.value); };
  return lapse(*first) <= soon && lapse(*at_last) <= kAtMost * soon;
}

bool WarningLevels::look(std::optional<bool> inside) {
  if (level_ == WarningLevel::lost) return false;
  const WarningLevel was = level_;
  const bool points = forecast() && inside != false && (inside || forecast()->eta < kHighest);
  soon_ = points && is_imminent() ? soon_ + 1 : 0;
  if (level_ == WarningLevel::none && points && near_ >= kNearLooks)
    level_ = WarningLevel::approaching;
  // Past the onset nothing is ahead any more, and nothing is taken back.
  if (inside == false || far_ >= kFarLooks) level_ = WarningLevel::none;
  if (soon_ >= kSoonStates) level_ = WarningLevel::imminent;
  return level_ != was;
}

bool WarningLevels::lose() {
  return std::exchange(level_, WarningLevel::lost) != WarningLevel::lost;
}

std::optional<double> WarningLevels::eta_forecast() const {
  if (!forecast() || forecast()->error > kVague * forecast()->eta) return std::nullopt;
  return forecast_.in_extension() ? -forecast()->eta : forecast()->eta;
}

std::optional<Outlook> WarningLevels::outlook(const State& now) const {
  const auto eta = eta_forecast();
  if (!eta) return std::nullopt;
  // An onset that was not passed lies ahead.
  const double low =
      std::max(forecast()->eta - kOf90 * forecast()->error, std::min(eta_now_, forecast()->eta));
  const double high = forecast()->eta + kOf90 * forecast()->error;
  Outlook told{.reading = now.reading,
               .time_s = {},
               .eta = *eta,
               .eta_low = low,
               .eta_high = high,
               .left = left(forecast()->eta)};
  if (has_time_) told.time_s = now.time_s;
  if (*eta < 0) told.eta_low = -high, told.eta_high = -low;
  return told;
}

}  // namespace triax::lab

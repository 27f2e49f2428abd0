// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/warning_levels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::lab {
namespace {

using Witness = OnsetForecast::Witness;

constexpr double kNear = 0.35;      ///< share of η that is left, by the forecast
constexpr double kNearWork = 0.25;  ///< likewise, as the normalised work itself has it
constexpr double kFar = 0.45;       ///< likewise, from which nothing is ahead
constexpr double kUnsure = 0.12;    ///< standard error of a forecast that says nothing, of η
constexpr double kHighest = 1.0;    ///< |η| at an onset where no limit is known
/// Normalised work above which no onset lies within a few scans: a load runs into it, a frame
/// walks.
constexpr double kStillStiff = 0.35, kStiffFrame = 0.2;
constexpr int kNearPoints = 3, kSoonStates = 2, kFarPoints = 10;  ///< in a row
constexpr double kScans = 5, kSeconds = 120, kShareOfStage = 0.2, kShareOfFrame = 0.05;
constexpr double kOf90 = 1.645;  ///< standard errors on each side of a 90 % interval

double progress_of(const State& s, bool has_time) { return has_time ? s.time_s : s.strain.axial; }

}  // namespace

void WarningLevels::start_stage(const StageInfo* stage) {
  *this = WarningLevels(has_time_);
  const Witness witness = OnsetForecast::witness_of(stage);
  watches_ = witness != Witness::none;
  held_q_ = witness == Witness::mixture || witness == Witness::pore_pressure;
  by_load_ = stage && stage->control == AxialControl::load;
  forecast_.start_stage(witness);
  by_work_.start_stage(watches_ && !held_q_ ? Witness::normalised : Witness::none);
}

void WarningLevels::add(const PathPoint& point) {
  if (!watches_) return;
  point_ = point;
  forecast_.add(point);
  by_work_.add(point);
  near_ = is_near() ? near_ + 1 : 0;
  far_ = is_far() ? far_ + 1 : 0;
}

/// Two witnesses that fall at different paces meet at the onset; where one does not fall the sand
/// goes to its limit surface, or gains strength again.
bool WarningLevels::agrees(double share) const {
  if (held_q_) return true;
  const auto& w = by_work_.now();
  if (!w) return false;
  const double latest = w->eta + w->error;
  return latest - std::max(eta_now_, w->now) <= share * latest;
}

/// Normalised work at the latest state: windows see only what lies half their length behind it.
double WarningLevels::work_now() const {
  const double seen = point_->work.normalised;
  const auto& w = held_q_ ? forecast_.now() : by_work_.now();
  if (!w || w->eta <= w->now) return seen;
  return seen * std::max(w->eta - std::max(eta_now_, w->now), 0.0) / (w->eta - w->now);
}

bool WarningLevels::is_near() const {
  const auto& f = forecast();
  return f && f->left() <= kNear && f->error <= kUnsure * f->eta && agrees(kNearWork);
}

/// Clearly no onset ahead: second-order work is positive beyond its scatter, and either witness
/// falls no longer, or would vanish far away, or was to vanish before.
bool WarningLevels::is_far() const {
  if (!point_->significantly_positive()) return false;
  const auto& f = forecast();
  if (!f || f->left() > kFar || f->error > 2 * kUnsure * f->eta) return true;
  if (held_q_) return false;
  const auto& w = by_work_.now();
  return !w || w->eta - w->error - w->now > kFar * (w->eta - w->error);
}

std::optional<double> WarningLevels::progress_left(double eta) const {
  const double left = std::max(eta - eta_now_, 0.0);
  const PathPoint& p = *point_;
  if (held_q_) {
    if (!(p.p_rate < 0)) return std::nullopt;
    const double q = std::fabs(p.q);
    return q * (1 / eta_now_ - 1 / (eta_now_ + left)) / -p.p_rate;
  }
  const double rate = (p.q_rate - p.eta() * p.p_rate) / p.p_eff * (p.q < 0 ? -1 : 1);
  if (!(rate > 0)) return std::nullopt;
  // Where dq/dε₁ falls linearly over η so does dq/dη, and under a load that grows steadily η runs
  // twice as far in what is left of the time as its present rate says.
  return (by_load_ ? 0.5 : 1.0) * left / rate;
}

std::optional<LeftToOnset> WarningLevels::left() const {
  const auto progress = progress_left(forecast()->eta);
  if (!progress) return std::nullopt;
  const PathPoint& p = *point_;
  LeftToOnset left{.quantity = Quantity::axial_strain, .value = 0, .time_s = {}};
  if (has_time_) left.time_s = *progress;
  double rate = p.axial_rate;
  if (by_load_) left.quantity = Quantity::deviator_stress, rate = p.q_rate;
  if (held_q_) left.quantity = Quantity::mean_effective_stress, rate = p.p_rate;
  left.value = std::fabs(rate) * *progress;
  return left;
}

bool WarningLevels::is_imminent() const {
  const EtaForecast& f = *forecast();
  if (f.error > kUnsure * f.eta || !agrees(kNearWork) ||
      (!held_q_ && work_now() > (by_load_ ? kStillStiff : kStiffFrame)))
    return false;
  // Not when it will be, but when it may be.
  const double may_be = f.eta - f.error;
  if (eta_now_ >= may_be) return true;
  const auto left = progress_left(may_be);
  if (!left || !before_) return false;
  const auto since = [&](const State& s) {
    return std::fabs(progress_of(*state_, has_time_) - progress_of(s, has_time_));
  };
  const double share = (by_load_ || held_q_ ? kShareOfStage : kShareOfFrame) * since(*first_);
  return *left <= std::max(kScans * since(*before_), has_time_ ? std::min(kSeconds, share) : share);
}

bool WarningLevels::look(const State& state, std::optional<bool> inside) {
  if (!watches_) return false;
  if (!first_) first_ = state;
  before_ = std::exchange(state_, state);
  const double eta = std::fabs(state.eta());
  eta_now_ = before_ ? std::min(eta, eta_before_) : eta;
  eta_before_ = eta;
  if (level_ == WarningLevel::lost) return false;
  const WarningLevel was = level_;
  const bool points = forecast() && inside != false && (inside || forecast()->eta < kHighest);
  soon_ = points && is_imminent() ? soon_ + 1 : 0;
  if (level_ == WarningLevel::none && points && near_ >= kNearPoints)
    level_ = WarningLevel::approaching;
  // Past the onset nothing is ahead any more, and nothing is taken back.
  if (inside == false || far_ >= kFarPoints) level_ = WarningLevel::none;
  if (soon_ >= kSoonStates) level_ = WarningLevel::imminent;
  return level_ != was;
}

bool WarningLevels::lose() {
  return std::exchange(level_, WarningLevel::lost) != WarningLevel::lost;
}

std::optional<double> WarningLevels::eta_forecast() const {
  if (!forecast() || !point_) return std::nullopt;
  return point_->q < 0 ? -forecast()->eta : forecast()->eta;
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
               .left = left()};
  if (has_time_) told.time_s = now.time_s;
  if (*eta < 0) told.eta_low = -high, told.eta_high = -low;
  return told;
}

}  // namespace triax::lab

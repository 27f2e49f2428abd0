// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/onset_forecast.hpp"

#include <algorithm>
#include <cmath>

#include "lab/measured/path_sampler.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kLooks = 128;
constexpr std::size_t kLeastLooks = 5;
constexpr double kLeastIndependent = 2.5;
constexpr double kCovered = 0.02;  ///< of the η forecast: what has to be seen of it in the stage
constexpr double kModel = 0.15;    ///< of the distance left: what a straight line errs by
/// A forecast is held to its word where this share of η is left and its standard error is below
/// that share.
constexpr double kSoon = 0.15, kConfident = 0.1, kBreach = 0.04;

}  // namespace

OnsetForecast::Witness OnsetForecast::witness_of(const StageInfo* stage) {
  if (stage && stage->control == AxialControl::constant_q)
    return stage->drainage == Drainage::closed ? Witness::pore_pressure : Witness::mixture;
  if (is_drained_frame(stage) && !stage->strain_path_R) return Witness::none;
  return Witness::stiffness;
}

void OnsetForecast::start_stage(Witness witness) {
  *this = OnsetForecast(reach_);
  witness_ = witness;
}

std::optional<OnsetForecast::Look> OnsetForecast::look_at(const PathPoint& p) const {
  const double shear = p.axial_rate - p.volumetric_rate / 3;
  const double stress = std::sqrt(3 * p.p_rate * p.p_rate + p.q_rate * p.q_rate * 2 / 3);
  const double strain = std::sqrt(p.volumetric_rate * p.volumetric_rate / 3 + 1.5 * shear * shear);
  if (!(stress > 0) || !(strain > 0) || !(p.p_eff > 0)) return std::nullopt;
  Look look{.eta = std::fabs(p.eta())};
  if (witness_ == Witness::pore_pressure) {
    if (p.p_rate == 0) return std::nullopt;
    look.y = p.pore_rate / p.p_rate;
    look.sigma = std::hypot(p.pore_rate_error, look.y * p.p_rate_error) / std::fabs(p.p_rate);
  } else {
    const double b = witness_ == Witness::stiffness ? -1 : witness_ == Witness::mixture ? 0.25 : 0;
    const double factor = std::pow(strain / stress, b);
    look.y = p.work.normalised * factor;
    look.sigma = std::max(p.normalised_error, 1e-3) * factor;
  }
  if (!(look.sigma > 0)) return std::nullopt;
  // Windows overlap; their slopes know little of each other from half a window on.
  look.share =
      std::min(1.0, 2 * (p.reading - last_reading_) / static_cast<double>(p.window_readings));
  return look;
}

void OnsetForecast::add(const PathPoint& point) {
  if (witness_ == Witness::none) return;
  if (const bool extension = point.q < 0; extension != in_extension_) {
    start_stage(witness_);
    in_extension_ = extension;
  }
  if (last_reading_ == 0) last_reading_ = point.reading - 1;
  const auto look = look_at(point);
  last_reading_ = point.reading;
  if (!look) return;
  remember(*look);
  // Of a long stage a look is thousands of points, and a part of them moves no line.
  if (in_last_ % std::max(1, merged_ / 8) == 0) forecast_ = made();
  if (!forecast_) return;
  forecast_->now = look->eta;
  if (forecast_->left() <= kSoon && forecast_->error <= kConfident * forecast_->eta)
    promised_ = std::min(
        promised_, forecast_->eta + std::max(2.5 * forecast_->error, kBreach * forecast_->eta));
}

void OnsetForecast::remember(const Look& look) {
  const auto merge = [](const Look& a, const Look& b) {
    const double wa = a.share / (a.sigma * a.sigma), wb = b.share / (b.sigma * b.sigma);
    return Look{.eta = (wa * a.eta + wb * b.eta) / (wa + wb),
                .y = (wa * a.y + wb * b.y) / (wa + wb),
                .sigma = std::sqrt((a.share + b.share) / (wa + wb)),
                .share = a.share + b.share};
  };
  if (!looks_.empty() && in_last_ < merged_) {
    looks_.back() = merge(looks_.back(), look);
    ++in_last_;
    return;
  }
  if (looks_.size() == kLooks) {
    for (std::size_t i = 0; i < kLooks / 2; ++i)
      looks_[i] = merge(looks_[2 * i], looks_[2 * i + 1]);
    looks_.resize(kLooks / 2);
    merged_ *= 2;
  }
  looks_.push_back(look);
  in_last_ = 1;
}

/// Through looks no farther from the onset than `reach` times the distance that is left, and as
/// many more as make enough independent ones.
StraightLine OnsetForecast::through(double distance, double reach) const {
  StraightLine line;
  const double now = looks_.back().eta;
  for (std::size_t i = looks_.size(); i-- > 0;) {
    const double behind = now - looks_[i].eta + distance;
    if (behind > reach * distance && line.independent() >= kLeastIndependent) break;
    line.add(looks_[i].eta, looks_[i].y, looks_[i].sigma, looks_[i].share);
  }
  return line;
}

std::optional<EtaForecast> OnsetForecast::made() const {
  if (looks_.size() < kLeastLooks || looks_.back().eta > promised_) return std::nullopt;
  const double now = looks_.back().eta, least = 0.01 * now;
  double distance = forecast_ ? std::max(forecast_->eta - now, least) : now;
  std::optional<StraightLine::Zero> zero;
  for (int round = 0; round < 3; ++round) {
    const StraightLine line = through(distance, reach_);
    zero = line.zero();
    if (!zero || line.independent() < kLeastIndependent) return std::nullopt;
    distance = std::max(zero->x - now, least);
  }
  if (now - looks_.front().eta < kCovered * zero->x) return std::nullopt;
  // What half the reach says: how far the line is bent.
  const auto nearer = through(distance, (1 + reach_) / 2).zero();
  const double bent = nearer && nearer->error < distance ? nearer->x - zero->x : 0;
  const double model = std::hypot(kModel * distance, bent);
  return EtaForecast{.eta = zero->x, .error = std::hypot(zero->error, model), .now = now};
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/limit_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/results/summary.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {

LimitSurface::LimitSurface(const SpecimenInfo& specimen) {
  given_angle_ = specimen.limit_friction_angle_rad;
}

namespace {

constexpr double kNear = 0.95;  ///< of the limit's stress ratio
constexpr const char* kGiveAngle = "give --set specimen.limit_friction_angle_deg=...";

double ratio_at(double angle, bool compression) {
  return compression ? sim::stress_ratio_at_friction_angle(angle)
                     : 6 * std::sin(angle) / (3 + std::sin(angle));
}

bool is_below(double eta, double angle) {
  return std::fabs(eta) < kNear * ratio_at(angle, eta >= 0);
}

}  // namespace

void LimitSurface::add(double reading, double q_pa, double p_eff_pa) {
  // Near p' = 0 the ratio of two small numbers says nothing; 3 and −1.5 are the ratios at σ₃' = 0
  // and σ₁' = 0.
  p_largest_ = std::max(p_largest_, p_eff_pa);
  const double eta = q_pa / p_eff_pa;
  if (p_eff_pa < 0.03 * p_largest_ || eta > 3 || eta < -1.5) return;
  const double angle = sim::mobilised_friction_angle(eta);
  watch_softening(p_eff_pa, angle);
  follow_walk(reading, std::fabs(q_pa), angle);
}

void LimitSurface::watch_softening(double p_eff_pa, double angle) {
  if (angle >= largest_angle_.value_or(0)) {
    largest_angle_ = angle;
    p_at_largest_ = p_eff_pa;
    softened_ = false;
  } else if (std::sin(angle) < kBand * std::sin(*largest_angle_) &&
             p_eff_pa >= kBand * p_at_largest_) {
    softened_ = true;
  }
}

void LimitSurface::follow_walk(double reading, double strength_pa, double angle) {
  if (!(angle > 0)) return;
  const bool near = std::sin(angle) >= kNear * std::sin(*largest_angle_);
  // A new largest ratio beyond the walk's begins another one.
  if (!near || std::sin(angle) * kBand > std::sin(walk_least_)) {
    walk_start_.reset();
    walk_angle_ = 0;
    walk_least_ = angle;
  }
  if (!near) return;
  if (!walk_start_) walk_start_ = strength_pa;
  walk_start_ = std::min(*walk_start_, strength_pa);
  walk_angle_ = std::max(walk_angle_, angle);
  walk_least_ = std::min(walk_least_, angle);
  if (strength_pa < (1 + kWalk) * *walk_start_) return;
  if (!walks_.empty() && walk_angle_ <= 1.01 * walks_.back().angle) return;
  if (walks_.size() < kMostWalks) walks_.push_back({reading, walk_angle_});
}

std::optional<double> LimitSurface::stress_ratio() const {
  const auto& angle = given_angle_ ? given_angle_ : largest_angle_;
  return angle ? std::optional(sim::stress_ratio_at_friction_angle(*angle)) : std::nullopt;
}

double LimitSurface::below(double eta) const {
  return given_angle_ ? 1 - std::fabs(eta) / ratio_at(*given_angle_, eta >= 0) : 1;
}

std::string LimitSurface::source(bool is_known) const {
  if (given_angle_) return kGivenLimit;
  if (!largest_angle_) return fmt::format("unknown; {}", kGiveAngle);
  if (is_known) return "largest stress ratio of this test, at which the specimen failed";
  return fmt::format(
      "unknown: no friction angle is given, and the {:.1f}° mobilised in this test may be below "
      "it; {}",
      sim::degrees(*largest_angle_), kGiveAngle);
}

std::optional<bool> LimitSurface::inside(double eta, double onset_reading) const {
  if (given_angle_) return is_below(eta, *given_angle_);
  if (went_beyond(eta)) return std::nullopt;
  if (softened_) return false;
  for (const Walk& walk : walks_)
    if (walk.reading < onset_reading && !is_below(eta, walk.angle)) return false;
  return std::nullopt;
}

bool LimitSurface::went_beyond(double eta) const {
  return !given_angle_ && largest_angle_ && is_below(eta, *largest_angle_);
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/limit_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/measured/assessment_limits.hpp"
#include "lab/results/summary.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {
namespace {

namespace limits = assessment_limits;
constexpr const char* kGiveAngle = "give --set specimen.limit_friction_angle_deg=...";

}  // namespace

LimitSurface::Angle::Angle(double angle_rad)
    : rad(angle_rad), sine(std::sin(angle_rad)), cosine(std::cos(angle_rad)) {}

LimitSurface::LimitSurface(const SpecimenInfo& specimen)
    : cohesion_pa_(specimen.cohesion_pa.value_or(0)) {
  if (specimen.limit_friction_angle_rad) given_angle_.emplace(*specimen.limit_friction_angle_rad);
}

double LimitSurface::strength_at(const Angle& angle, double p_eff_pa, bool compression) const {
  return 6 * (p_eff_pa * angle.sine + cohesion_pa_ * angle.cosine) /
         (compression ? 3 - angle.sine : 3 + angle.sine);
}

bool LimitSurface::is_below(double q_pa, double p_eff_pa, const Angle& angle) const {
  return std::fabs(q_pa) < limits::kInside * strength_at(angle, p_eff_pa, q_pa >= 0);
}

/// 3|q| = sin φ (6p' + q) + 6 c cos φ in compression and in extension.
double LimitSurface::mobilised_angle(double q_pa, double p_eff_pa) const {
  const double along = 6 * p_eff_pa + q_pa, across = 6 * cohesion_pa_;
  return std::asin(3 * std::fabs(q_pa) / std::hypot(along, across)) - std::atan2(across, along);
}

bool LimitSurface::is_steep(double q_pa, double p_eff_pa) const {
  // sin φ is at most 3|q|/(6p' + q) for any cohesion. kRounding is far above rounding errors.
  constexpr double kRounding = 1e-6;
  const double along = 6 * p_eff_pa + q_pa;
  if (3 * std::fabs(q_pa) < (1 - kRounding) * std::sin(limits::kSteepest) * along) return false;
  return mobilised_angle(q_pa, p_eff_pa) > limits::kSteepest;
}

void LimitSurface::add(double reading, double q_pa, double p_eff_pa) {
  // Near p' = 0 the ratio of two small numbers says nothing; 3 and −1.5 are the ratios at σ₃' = 0
  // and σ₁' = 0.
  p_largest_ = std::max(p_largest_, p_eff_pa);
  const double eta = q_pa / p_eff_pa;
  if (p_eff_pa < 0.03 * p_largest_ || eta > 3 || eta < -1.5) return;
  const double mobilised = mobilised_angle(q_pa, p_eff_pa);
  if (std::isnan(mobilised)) return;
  const double angle = std::max(mobilised, 0.0);  // below it cohesion alone carries q
  watch_softening(p_eff_pa, angle);
  follow_walk(reading, std::fabs(q_pa), angle);
}

void LimitSurface::watch_softening(double p_eff_pa, double angle) {
  if (angle >= (largest_angle_ ? largest_angle_->rad : 0)) {
    largest_angle_.emplace(angle);
    p_at_largest_ = p_eff_pa;
    softened_ = false;
  } else if (std::sin(angle) < limits::kBand * largest_angle_->sine &&
             p_eff_pa >= limits::kBand * p_at_largest_) {
    softened_ = true;
  }
}

void LimitSurface::follow_walk(double reading, double strength_pa, double angle) {
  if (!(angle > 0)) return;
  const bool near = std::sin(angle) >= limits::kInside * largest_angle_->sine;
  // A new largest ratio beyond the walk's begins another one.
  if (!near || std::sin(angle) * limits::kBand > std::sin(walk_least_)) {
    walk_start_.reset();
    walk_angle_ = 0;
    walk_least_ = angle;
  }
  if (!near) return;
  if (!walk_start_) walk_start_ = strength_pa;
  walk_start_ = std::min(*walk_start_, strength_pa);
  walk_angle_ = std::max(walk_angle_, angle);
  walk_least_ = std::min(walk_least_, angle);
  if (strength_pa < (1 + limits::kWalk) * *walk_start_) return;
  if (!walks_.empty() && walk_angle_ <= 1.01 * walks_.back().angle.rad) return;
  if (walks_.size() < kMaxWalks) walks_.push_back({reading, Angle(walk_angle_)});
}

std::optional<double> LimitSurface::stress_ratio() const {
  const auto& angle = given_angle_ ? given_angle_ : largest_angle_;
  return angle ? std::optional(sim::stress_ratio_at_friction_angle(angle->rad)) : std::nullopt;
}

std::optional<double> LimitSurface::intercept_pa() const {
  const auto& angle = given_angle_ ? given_angle_ : largest_angle_;
  if (!angle || cohesion_pa_ == 0) return std::nullopt;
  return strength_at(*angle, 0, true);
}

double LimitSurface::below(double q_pa, double p_eff_pa) const {
  if (!given_angle_) return 1;
  return 1 - std::fabs(q_pa) / strength_at(*given_angle_, p_eff_pa, q_pa >= 0);
}

std::string LimitSurface::source(bool is_known) const {
  if (given_angle_) return cohesion_pa_ > 0 ? kGivenLimitWithCohesion : kGivenLimit;
  if (!largest_angle_) return fmt::format("unknown; {}", kGiveAngle);
  if (is_known) return "largest stress ratio of this test, at which the specimen failed";
  return fmt::format(
      "unknown: no friction angle is given, and the {:.1f}° mobilised in this test may be below "
      "it; {}",
      sim::degrees(largest_angle_->rad), kGiveAngle);
}

std::optional<bool> LimitSurface::inside(double q_pa, double p_eff_pa, double onset_reading) const {
  if (given_angle_) return is_below(q_pa, p_eff_pa, *given_angle_);
  if (went_beyond(q_pa, p_eff_pa)) return std::nullopt;
  if (softened_) return false;
  for (const Walk& walk : walks_)
    if (walk.reading < onset_reading && !is_below(q_pa, p_eff_pa, walk.angle)) return false;
  return std::nullopt;
}

bool LimitSurface::went_beyond(double q_pa, double p_eff_pa) const {
  return !given_angle_ && largest_angle_ && is_below(q_pa, p_eff_pa, *largest_angle_);
}

std::string LimitSurface::needs_cohesion(double q_pa, double p_eff_pa) const {
  if (given_angle_ || !is_steep(q_pa, p_eff_pa)) return {};
  return fmt::format(
      "q/p' is {:.2f}, {:.1f}° of friction without cohesion, more than friction alone carries: "
      "over-consolidated clay, cemented soil and rock have cohesion. With c' and φ' unknown a loss "
      "of strength can be failure; give --set specimen.cohesion_kPa=... and --set "
      "specimen.limit_friction_angle_deg=...",
      q_pa / p_eff_pa, sim::degrees(sim::mobilised_friction_angle(q_pa / p_eff_pa)));
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/limit_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {

LimitSurface::LimitSurface(const SpecimenInfo& specimen) {
  given_angle_ = specimen.limit_friction_angle_rad;
}

void LimitSurface::add(const PathPoint& point) {
  // Near p' = 0 the ratio of two small numbers says nothing; 3 and −1.5 are the ratios at σ₃' = 0
  // and σ₁' = 0.
  p_largest_ = std::max(p_largest_, point.p_eff);
  if (point.p_eff < 0.03 * p_largest_ || point.eta() > 3 || point.eta() < -1.5) return;
  const double angle = sim::mobilised_friction_angle(point.eta());
  largest_angle_ = std::max(largest_angle_.value_or(0), angle);
}

std::optional<double> LimitSurface::stress_ratio() const {
  const auto& angle = given_angle_ ? given_angle_ : largest_angle_;
  return angle ? std::optional(sim::stress_ratio_at_friction_angle(*angle)) : std::nullopt;
}

std::string LimitSurface::source() const {
  if (given_angle_) return "friction angle of the specimen";
  return largest_angle_ ? "largest stress ratio mobilised in this test" : "unknown";
}

bool LimitSurface::inside(double eta) const {
  const auto& angle = given_angle_ ? given_angle_ : largest_angle_;
  if (!angle) return false;
  const double in_extension = 6 * std::sin(*angle) / (3 + std::sin(*angle));
  const double limit = eta >= 0 ? sim::stress_ratio_at_friction_angle(*angle) : in_extension;
  return std::fabs(eta) < 0.95 * limit;
}

}  // namespace triax::lab

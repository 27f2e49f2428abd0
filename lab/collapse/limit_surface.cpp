#include "lab/collapse/limit_surface.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {

LimitSurface::LimitSurface(const SpecimenInfo& specimen) {
  if (specimen.limit_friction_angle_rad)
    given_ = sim::stress_ratio_at_friction_angle(*specimen.limit_friction_angle_rad);
}

void LimitSurface::add(const PathPoint& point) {
  // Near p' = 0 the ratio of two small numbers says nothing; 3 is the ratio at σ₃' = 0.
  p_largest_ = std::max(p_largest_, point.p_eff);
  if (point.p_eff < 0.03 * p_largest_ || point.eta() > 3) return;
  largest_ = std::max(largest_.value_or(0), point.eta());
}

std::optional<double> LimitSurface::stress_ratio() const { return given_ ? given_ : largest_; }

std::string LimitSurface::source() const {
  if (given_) return "friction angle given for the specimen";
  return largest_ ? "largest stress ratio mobilised in this test" : "unknown";
}

bool LimitSurface::inside(double eta) const {
  const auto limit = stress_ratio();
  return limit && eta < 0.95 * *limit;
}

}  // namespace triax::lab

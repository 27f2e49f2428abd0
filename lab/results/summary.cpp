#include "lab/results/summary.hpp"

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {

std::string_view to_string(CollapseKind kind) {
  switch (kind) {
    case CollapseKind::none:
      return "none";
    case CollapseKind::limited:
      return "limited";
    case CollapseKind::flow:
      return "flow";
  }
  return {};
}

std::optional<CollapseKind> collapse_kind_from(std::string_view text) {
  for (const auto kind : {CollapseKind::none, CollapseKind::limited, CollapseKind::flow})
    if (to_string(kind) == text) return kind;
  return std::nullopt;
}

std::optional<double> Instant::phi_mob_rad() const {
  const auto ratio = eta();
  if (!ratio) return std::nullopt;
  const double angle = sim::mobilised_friction_angle(*ratio);
  return std::isfinite(angle) ? std::optional(angle) : std::nullopt;
}

}  // namespace triax::lab

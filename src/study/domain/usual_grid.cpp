// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/usual_grid.hpp"

#include <algorithm>
#include <cmath>

#include "sim/stability/domain_criteria.hpp"

namespace triax::study {

GridLine usual_p(const lab::MaterialSet& material) {
  GridLine p{10, 300, 200};
  if (!material.p_eff_range_kPa) return p;
  const auto [low, high] = *material.p_eff_range_kPa;
  p.from = std::max(p.from, low);
  if (high > p.from) p.to = std::min(p.to, high);
  return p;
}

GridLine usual_q(const lab::MaterialSet& material, const GridLine& p) {
  const auto* law = material.material.axisymmetric.get();
  const double ratio = (law != nullptr ? law->limit_stress_ratio() : std::nullopt).value_or(1.5);
  return {0, 10 * std::ceil(ratio * p.to / 10), 200};
}

std::vector<std::string> possible_criteria(const lab::MaterialSet& material,
                                           const DomainSettings::Grid& grid,
                                           const std::vector<std::string>& asked) {
  std::vector<std::string> names;
  for (const auto& criterion : sim::domain_criteria(material.material, domain_grid(grid), asked))
    names.emplace_back(criterion.name);
  return names;
}

}  // namespace triax::study

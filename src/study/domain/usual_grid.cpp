// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/usual_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "sim/stability/domain_criteria.hpp"
#include "src/study/domain/domain_piece.hpp"

namespace triax::study {
namespace {

void check_law(const lab::MaterialSet& material, const std::string& plane,
               const std::string& option) {
  const bool axisymmetric = plane == "axisymmetric";
  const auto& law = material.material;
  const std::string why = law.no_tensor.empty() ? "" : ": " + law.no_tensor;
  if (axisymmetric ? law.axisymmetric == nullptr : law.tensor == nullptr)
    throw lab::BadInput(fmt::format("{}{}: {} is not formulated for it{}", option, plane,
                                    material.name, axisymmetric ? "" : why));
}

std::string no_tangents(const lab::MaterialSet& material, const std::string& criterion) {
  const auto& law = material.material;
  if (law.tensor != nullptr)
    return fmt::format(
        "{}: {} is a law of finite increments without tangents, which are needed here", criterion,
        material.name);
  return fmt::format("{} needs the full tensor, and {} is not formulated for it{}", criterion,
                     material.name, law.no_tensor.empty() ? "" : ", " + law.no_tensor);
}

std::vector<std::string> possible_criteria(const lab::MaterialSet& material,
                                           const DomainSettings::Grid& grid,
                                           const std::vector<std::string>& asked) {
  std::vector<std::string> names;
  for (const auto& criterion : sim::domain_criteria(material.material, domain_grid(grid), asked))
    names.emplace_back(criterion.name);
  return names;
}

}  // namespace

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

DomainSettings::Grid asked_grid(const lab::MaterialSet& material, const GridWish& wish,
                                const GridWords& words) {
  DomainSettings::Grid grid{.p_from_kPa = wish.p.from,
                            .p_to_kPa = wish.p.to,
                            .q_from_kPa = wish.q.from,
                            .q_to_kPa = wish.q.to,
                            .columns = wish.p.count,
                            .rows = wish.q.count,
                            .void_ratio = wish.void_ratio,
                            .plane = wish.plane,
                            .directions = wish.directions,
                            .criteria = {}};
  check_grid(grid, "the grid");
  check_law(material, wish.plane, words.plane);
  grid.criteria = possible_criteria(material, grid, wish.criteria);
  for (const std::string& asked : wish.criteria)
    if (!grid.looks_for(asked)) throw lab::BadInput(no_tangents(material, words.criterion + asked));
  return grid;
}

}  // namespace triax::study

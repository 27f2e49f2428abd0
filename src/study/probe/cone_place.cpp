// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/cone_place.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::study {
namespace {

double turned(double angle) {
  const double rest = std::fmod(angle, 2 * std::numbers::pi);
  return rest < 0 ? rest + 2 * std::numbers::pi : rest;
}

}  // namespace

std::optional<ConePlace> place_among(const std::vector<sim::Cone>& cones, double angle) {
  std::optional<ConePlace> nearest;
  for (std::size_t i = 0; i < cones.size(); ++i) {
    const auto& [from, to, strongest] = cones[i];
    if (cones[i].contains(angle))
      return ConePlace{true, i, std::min(turned(angle - from), turned(to - angle))};
    const double to_edge = std::min(turned(from - angle), turned(angle - to));
    if (!nearest || to_edge < nearest->to_edge) nearest = ConePlace{false, i, to_edge};
  }
  return nearest;
}

}  // namespace triax::study

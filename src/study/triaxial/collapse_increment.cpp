// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/collapse_increment.hpp"

#include <algorithm>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::study {

double CollapseIncrement::degrees_from_unloading() const {
  // Isotropic unloading lies at 180°: turned about, no direction near it jumps.
  return std::remainder(sim::degrees(std::atan2(dq, dp)) - 180, 360);
}

DirectionRange direction_range(const std::vector<CollapseIncrement>& increments) {
  const auto [low, high] =
      std::minmax_element(increments.begin(), increments.end(), [](const auto& a, const auto& b) {
        return a.degrees_from_unloading() < b.degrees_from_unloading();
      });
  return {low->degrees_from_unloading(), high->degrees_from_unloading()};
}

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <utility>

#include "sim/materials/elastic.hpp"

namespace triax::sim {

/// A state this far (as a ratio) outside the yield surface is no round-off.
inline constexpr double kFarOutside = 1e-6;

/// Friction angle, cohesion and dilation angle, for a perfectly plastic law whose parameters hold
/// friction_angle, cohesion_pa and dilation_angle (rad, Pa).
template <class Parameters>
ParameterTable<Parameters> strength_rows() {
  using P = Parameters;
  return {{{.key = "friction_angle_deg",
            .symbol = "φ",
            .unit = "deg",
            .meaning = "friction angle in triaxial compression",
            .range = {.at_least = 0, .below = 90}},
           &P::friction_angle},
          {{.key = "cohesion_kPa",
            .symbol = "c",
            .unit = "kPa",
            .meaning = "cohesion",
            .range = {.at_least = 0},
            .usual = 0},
           &P::cohesion_pa},
          {{.key = "dilation_angle_deg",
            .symbol = "ψ",
            .unit = "deg",
            .meaning = "dilation angle in triaxial compression",
            .range = {.above = -90, .below = 90},
            .usual = 0},
           &P::dilation_angle}};
}

/// Elasticity within and strength: the whole table of such a law.
template <class Parameters>
ParameterTable<Parameters> elastic_and_strength_rows() {
  ParameterTable<Parameters> rows = elastic_rows<Parameters>();
  for (auto& row : strength_rows<Parameters>()) rows.push_back(std::move(row));
  return rows;
}

/// Throws std::invalid_argument where there is neither friction nor cohesion.
template <class Parameters>
void check_strength(const Parameters& p) {
  if (p.friction_angle == 0 && p.cohesion_pa == 0)
    throw std::invalid_argument(
        "friction_angle_deg and cohesion_kPa are both 0, one must be above 0");
}

}  // namespace triax::sim

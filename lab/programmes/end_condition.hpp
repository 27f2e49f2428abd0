// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>
#include <string_view>

namespace triax::lab {

/// What a stage's end can depend on. Values are what the instruments say, reduced as in a report:
/// strains count from the start of the first shear stage (of a consolidation stage before that),
/// time from the start of the stage.
enum class EndQuantity {
  time,
  cell_pressure,
  back_pressure,
  pore_pressure,
  pore_pressure_lag,  ///< |u − u_b|
  deviator_stress,
  mean_effective_stress,
  stress_ratio,
  axial_strain,
  volumetric_strain,
  axial_displacement,
  axial_force,
  effective_axial_stress,
  effective_radial_stress,
  void_ratio,
  back_volume,  ///< into the specimen
  volume_rate,  ///< |dV_b/dt| over the last half minute
  axial_rate,   ///< |dδ/dt| over the last half minute
  b_value,      ///< Δu/Δσ_c since the start of the stage, once σ_c has moved by 5 kPa
};
inline constexpr int kEndQuantityCount = 19;

/// A quantity as programmes write it: key with its unit, and the values that it can take at all.
struct EndQuantityKey {
  std::string_view key;
  EndQuantity quantity;
  double scale;            ///< SI units per unit of the key
  double lowest, highest;  ///< in the unit of the key
};
std::span<const EndQuantityKey> end_quantity_keys();

/// True once the quantity is at or beyond the bound. Exactly one bound is set. SI.
struct EndCondition {
  EndQuantity quantity = EndQuantity::time;
  std::optional<double> above;
  std::optional<double> below;
  bool met(double value) const { return (above && value >= *above) || (below && value <= *below); }
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <vector>

#include "sim/point/path.hpp"

namespace triax::sim {

/// The point at one instant of its path.
template <class Space>
struct PathPoint {
  std::size_t segment = 0;
  double progress = 0;                           ///< of the segment, 0 to 1
  Vector<Space> stress = Vector<Space>::Zero();  ///< σ′, Pa
  Vector<Space> strain = Vector<Space>::Zero();  ///< since the start of the path
  double void_ratio = 0;
  double pore_pressure = 0;    ///< Pa
  std::vector<double> memory;  ///< of the law
  // Of the rate with which the path goes on from here; empty where it cannot, or nothing moves.
  std::optional<double> second_order_work;  ///< dσ′:dε/(|dσ′| |dε|)
  std::optional<double> determinant;        ///< of the control, PointRate::determinant

  double p() const { return mean_stress<Space>(stress); }
  double q() const { return deviator_stress<Space>(stress); }
  std::optional<double> stress_ratio() const {
    return p() > 0 ? std::optional(q() / p()) : std::nullopt;
  }
};

/// Empty only for the stress ratio where p′ ≤ 0.
template <class Space>
std::optional<double> value_of(PathQuantity quantity, int component, const PathPoint<Space>& at);

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a direction lies to cones of unstable directions.
#include <optional>
#include <vector>

#include "sim/stability/cones.hpp"

namespace triax::study {

struct ConePlace {
  bool inside = false;
  std::size_t cone = 0;  ///< the one it is in, or the nearest
  double to_edge = 0;    ///< to the nearest edge of that cone, rad, ≥ 0
  /// Whether an angle with this standard error lies where it seems to: two of them from the edge.
  bool certain(double error) const { return to_edge >= 2 * error; }
};

/// `angle`: rad, from 0 to 2π. Empty where there is no cone.
std::optional<ConePlace> place_among(const std::vector<sim::Cone>& cones, double angle);

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>
#include <vector>

#include "sim/point/path.hpp"

namespace triax::lab {

/// A quantity as the end conditions of a path write it, and the values that it can take at all.
struct PathQuantityKey {
  std::string_view key;
  sim::PathQuantity quantity;
  int component;           ///< of a tensor, 0 to 5
  double scale;            ///< SI units per unit of the key
  double lowest, highest;  ///< in the unit of the key
};
/// The triaxial ones first; those of components behind them.
const std::vector<PathQuantityKey>& path_quantity_keys();

}  // namespace triax::lab

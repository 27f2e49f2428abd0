// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/plot/shapes.hpp"

namespace triax::src {

/// Values on a square raster, row by row from below; not finite where unknown.
struct Raster {
  int size = 0;                ///< places in a row, and rows
  double low = -1, high = 1;   ///< coordinates of the first and the last place
  std::vector<double> values;  ///< size²

  double coordinate(int i) const { return low + (high - low) * i / (size - 1); }
  double at(int column, int row) const;
};

/// The lines on which a raster is 0, linear between its places (marching squares), each in one
/// piece, with gaps between them. None passes a square with an unknown corner.
Points zero_line(const Raster& raster);

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cells of a box, for sorting grains so that neighbours lie close in memory, and for finding pairs.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

class CellGrid {
 public:
  /// Cells of about 0.55 times the largest distance at which a pair is listed, larger in a loose
  /// box.
  explicit CellGrid(const GrainState& state);

  /// Puts the grains (and their ids) in the order of the cells, keeping the order within a cell,
  /// and returns where each went.
  std::vector<std::int32_t> sort(GrainState& state) const;

  /// Every pair i < j of sorted grains with a gap below `margin_m`, ascending in (i, j).
  void list_pairs(const GrainState& state, double margin_m, std::vector<std::int32_t>& list_i,
                  std::vector<std::int32_t>& list_j) const;

 private:
  int along(int axis, double x) const;
  int cell_of(const Grain& g) const;

  std::array<double, 3> low_{}, per_m_{};
  std::array<int, 3> count_{};
  double largest_radius_ = 0;
};

}  // namespace triax::sim

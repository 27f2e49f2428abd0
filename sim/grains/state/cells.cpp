// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/cells.hpp"

#include <algorithm>
#include <cmath>

namespace triax::sim {
namespace {

constexpr double kCellOverReach = 0.55;
constexpr int kMostCells = 1 << 10;   ///< along one axis: a box may be thin
constexpr double kCellsPerGrain = 4;  ///< at most: a box may be nearly empty

}  // namespace

CellGrid::CellGrid(const GrainState& state) : low_(state.box.low_m) {
  for (const Grain& g : state.grains) largest_radius_ = std::max(largest_radius_, g.radius);
  const double by_reach = kCellOverReach * (2 * largest_radius_ + state.margin.listed_m);
  const double cells = kCellsPerGrain * static_cast<double>(state.grains.size());
  const double edge = std::max(by_reach, std::cbrt(state.box.volume_m3() / cells));
  for (int a = 0; a < 3; ++a) {
    const double length = state.box.length_m(a);
    count_[a] = static_cast<int>(std::clamp(length / edge, 1.0, double(kMostCells)));
    per_m_[a] = count_[a] / length;
  }
}

int CellGrid::along(int axis, double x) const {
  const double cell = std::clamp((x - low_[axis]) * per_m_[axis], 0.0, double(count_[axis] - 1));
  return static_cast<int>(cell);
}

int CellGrid::cell_of(const Grain& g) const {
  return (along(2, g.position[2]) * count_[1] + along(1, g.position[1])) * count_[0] +
         along(0, g.position[0]);
}

std::vector<std::int32_t> CellGrid::sort(GrainState& state) const {
  const std::size_t n = state.grains.size();
  std::vector<std::int32_t> next(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1);
  std::vector<std::int32_t> place(n);
  for (std::size_t i = 0; i < n; ++i) {
    place[i] = cell_of(state.grains[i]);
    ++next[place[i] + 1];
  }
  for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
  for (std::int32_t& p : place) p = next[p]++;

  AlignedVector<Grain> grains(n);
  std::vector<std::int32_t> ids(n);
  for (std::size_t i = 0; i < n; ++i) {
    grains[place[i]] = state.grains[i];
    ids[place[i]] = state.ids[i];
  }
  state.grains = std::move(grains);
  state.ids = std::move(ids);
  return place;
}

void CellGrid::list_pairs(const GrainState& state, double margin_m,
                          std::vector<std::int32_t>& list_i,
                          std::vector<std::int32_t>& list_j) const {
  const auto n = static_cast<std::int32_t>(state.grains.size());
  const std::size_t cells = static_cast<std::size_t>(count_[0]) * count_[1] * count_[2];
  std::vector<std::int32_t> start(cells + 1);
  for (const Grain& g : state.grains) ++start[cell_of(g) + 1];
  for (std::size_t c = 1; c <= cells; ++c) start[c] += start[c - 1];

  list_i.clear();
  list_j.clear();
  for (std::int32_t i = 0; i < n; ++i) {
    const Grain& g = state.grains[i];
    const double reach = g.radius + largest_radius_ + margin_m;
    std::array<int, 3> from{}, to{};
    for (int a = 0; a < 3; ++a) {
      from[a] = along(a, g.position[a] - reach);
      to[a] = along(a, g.position[a] + reach);
    }
    for (int z = from[2]; z <= to[2]; ++z)
      for (int y = from[1]; y <= to[1]; ++y) {
        const int row = (z * count_[1] + y) * count_[0];
        const std::int32_t end = start[row + to[0] + 1];
        for (std::int32_t j = std::max(i + 1, start[row + from[0]]); j < end; ++j) {
          const Grain& h = state.grains[j];
          const double dx = h.position[0] - g.position[0], dy = h.position[1] - g.position[1],
                       dz = h.position[2] - g.position[2];
          const double near = g.radius + h.radius + margin_m;
          if (dx * dx + dy * dy + dz * dz >= near * near) continue;
          list_i.push_back(i);
          list_j.push_back(j);
        }
      }
  }
}

}  // namespace triax::sim

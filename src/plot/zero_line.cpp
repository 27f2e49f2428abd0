// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/zero_line.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <list>
#include <map>
#include <optional>

namespace triax::src {
namespace {

/// A side of a square: its lower left place, and whether it runs up. A line crosses it once.
struct CellSide {
  int column, row;
  bool up;
  auto operator<=>(const CellSide&) const = default;
};

class Lines {
 public:
  explicit Lines(const Raster& raster) : raster_(raster) {
    for (int row = 0; row + 1 < raster.size; ++row)
      for (int column = 0; column + 1 < raster.size; ++column) add_square(column, row);
  }

  Points in_pieces() {
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    Points points;
    while (!ways_.empty()) {
      std::list<CellSide> line = {ways_.begin()->first};
      while (const auto next = step_from(line.back())) line.push_back(*next);
      while (const auto next = step_from(line.front())) line.push_front(*next);
      if (!points.empty()) points.emplace_back(kGap, kGap);
      for (const auto& side : line) points.push_back(crossing(side));
    }
    return points;
  }

 private:
  std::array<double, 2> ends(const CellSide& side) const {
    return {raster_.at(side.column, side.row), side.up ? raster_.at(side.column, side.row + 1)
                                                       : raster_.at(side.column + 1, side.row)};
  }

  QPointF crossing(const CellSide& side) const {
    const auto [a, b] = ends(side);
    const double part = a / (a - b);
    const double x = raster_.coordinate(side.column), y = raster_.coordinate(side.row);
    const double step = raster_.coordinate(1) - raster_.coordinate(0);
    return side.up ? QPointF(x, y + part * step) : QPointF(x + part * step, y);
  }

  // A line enters and leaves a square where the sign changes along its sides.
  void add_square(int column, int row) {
    const std::array<CellSide, 4> sides = {{{column, row, false},
                                            {column + 1, row, true},
                                            {column, row + 1, false},
                                            {column, row, true}}};
    std::vector<CellSide> crossed;
    for (const auto& side : sides) {
      const auto [a, b] = ends(side);
      if (!std::isfinite(a) || !std::isfinite(b)) return;
      if ((a < 0) != (b < 0)) crossed.push_back(side);
    }
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
      ways_.emplace(crossed[i], crossed[i + 1]);
      ways_.emplace(crossed[i + 1], crossed[i]);
    }
  }

  /// Takes one way out of a crossing, both directions of it.
  std::optional<CellSide> step_from(const CellSide& here) {
    const auto way = ways_.find(here);
    if (way == ways_.end()) return std::nullopt;
    const CellSide there = way->second;
    ways_.erase(way);
    const auto [first, last] = ways_.equal_range(there);
    for (auto back = first; back != last; ++back)
      if (back->second == here) {
        ways_.erase(back);
        break;
      }
    return there;
  }

  const Raster& raster_;
  std::multimap<CellSide, CellSide> ways_;
};

}  // namespace

double Raster::at(int column, int row) const {
  return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                static_cast<std::size_t>(column)];
}

Points zero_line(const Raster& raster) { return Lines(raster).in_pieces(); }

}  // namespace triax::src

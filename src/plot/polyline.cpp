// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::src {
namespace {

double distance_to_segment(const QPointF& point, const QPointF& from, const QPointF& to) {
  const QPointF way = to - from;
  const QPointF off = point - from;
  const double squared = QPointF::dotProduct(way, way);
  const double part =
      squared > 0 ? std::clamp(QPointF::dotProduct(off, way) / squared, 0.0, 1.0) : 0;
  const QPointF miss = off - way * part;
  return std::hypot(miss.x(), miss.y());
}

}  // namespace

std::vector<std::size_t> points_to_draw(const std::vector<QPointF>& points, double tolerance) {
  if (points.empty()) return {};
  std::vector<bool> kept(points.size(), false);
  kept.front() = true;
  kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to_segment(points[i], points[first], points[last]);
      if (distance <= most) continue;
      most = distance;
      farthest = i;
    }
    if (farthest == first) continue;
    kept[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) numbers.push_back(i);
  return numbers;
}

}  // namespace triax::src

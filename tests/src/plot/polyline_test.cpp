// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/polyline.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::src;

namespace {

double distance(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF way = b - a;
  const double t =
      std::clamp(QPointF::dotProduct(p - a, way) / QPointF::dotProduct(way, way), 0.0, 1.0);
  const QPointF miss = p - a - way * t;
  return std::hypot(miss.x(), miss.y());
}

}  // namespace

TEST_CASE("a straight line needs its two ends; a corner is kept") {
  std::vector<QPointF> points;
  for (int i = 0; i <= 100; ++i) points.emplace_back(i, 2 * i);
  CHECK(points_to_draw(points, 0.1) == std::vector<std::size_t>{0, 100});
  for (int i = 1; i <= 50; ++i) points.emplace_back(100 + i, 200 - i);
  CHECK(points_to_draw(points, 0.1) == std::vector<std::size_t>{0, 100, 150});
}

TEST_CASE("no point left out lies farther away than the tolerance") {
  std::vector<QPointF> points;
  for (int i = 0; i <= 3000; ++i)
    points.emplace_back(0.2 * i, 100 * std::sin(0.01 * i) + 20 * std::exp(-0.05 * i));
  const auto kept = points_to_draw(points, 0.1);
  CHECK(kept.size() > 20);
  CHECK(kept.size() < points.size() / 5);
  for (std::size_t k = 1; k < kept.size(); ++k)
    for (std::size_t i = kept[k - 1]; i <= kept[k]; ++i)
      REQUIRE(distance(points[i], points[kept[k - 1]], points[kept[k]]) <= 0.1 + 1e-9);
}

TEST_CASE("a path that returns to its start keeps its far end; none and one point are themselves") {
  const std::vector<QPointF> there_and_back = {{0, 0}, {5, 0}, {9, 0}, {4, 0}, {0, 0}};
  CHECK(points_to_draw(there_and_back, 0.1) == std::vector<std::size_t>{0, 2, 4});
  CHECK(points_to_draw({}, 0.1).empty());
  CHECK(points_to_draw({{1, 1}}, 0.1) == std::vector<std::size_t>{0});
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/zero_line.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace triax::src;

namespace {

template <class Value>
Raster raster(const Value& value) {
  Raster r{41, -1, 1, {}};
  for (int row = 0; row < r.size; ++row)
    for (int column = 0; column < r.size; ++column)
      r.values.push_back(value(r.coordinate(column), r.coordinate(row)));
  return r;
}

long gaps(const Points& points) {
  return std::count_if(points.begin(), points.end(),
                       [](const QPointF& p) { return !std::isfinite(p.x()); });
}

}  // namespace

TEST_CASE("a circle is one closed line at its radius") {
  const auto points =
      zero_line(raster([](double x, double y) { return std::hypot(x, y) - 0.613; }));
  REQUIRE(points.size() > 50);
  CHECK(gaps(points) == 0);
  for (const auto& p : points) CHECK(std::hypot(p.x(), p.y()) == Approx(0.613).margin(2e-3));
  CHECK(points.front() == points.back());
}

TEST_CASE("two regions are two lines with one gap; a plane is a straight line through exactly it") {
  const auto two = zero_line(raster([](double x, double y) {
    return std::min(std::hypot(x - 0.5, y), std::hypot(x + 0.5, y)) - 0.23;
  }));
  CHECK(gaps(two) == 1);
  const auto plane = zero_line(raster([](double x, double y) { return 2 * x + y - 0.123; }));
  CHECK(gaps(plane) == 0);
  for (const auto& p : plane) CHECK(2 * p.x() + p.y() == Approx(0.123).margin(1e-12));
}

TEST_CASE("no line where nothing changes sign or where nothing is known") {
  CHECK(zero_line(raster([](double, double) { return 1.0; })).empty());
  const auto half = zero_line(raster([](double x, double y) {
    return x < 0 ? std::numeric_limits<double>::quiet_NaN() : y - 0.01;
  }));
  REQUIRE_FALSE(half.empty());
  for (const auto& p : half) CHECK(p.x() >= 0);
}

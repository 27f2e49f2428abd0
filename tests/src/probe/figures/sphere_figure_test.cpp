// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/sphere_figure.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// Directions that cover the sphere evenly (a spiral), elastic with shear modulus alone, but W₂ < 0
/// within 30° of isotropic unloading.
std::vector<SphereDirection> directions() {
  std::vector<SphereDirection> all;
  const int n = 1500;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.0) / n, turn = i * std::numbers::pi * (3 - std::sqrt(5));
    const double r = std::sqrt(1 - z * z);
    SphereDirection d;
    d.direction = {r * std::cos(turn), r * std::sin(turn), z};
    d.response = d.direction;
    d.answered = true;
    const double unloading = -d.direction.sum() / std::sqrt(3);
    d.normalised = unloading > std::cos(sim::radians(30)) ? -0.4 : 0.6;
    all.push_back(d);
  }
  return all;
}

}  // namespace

TEST_CASE("the projection keeps areas, its middle is the hydrostatic axis, its rim the deviator") {
  const Eigen::Vector3d h = Eigen::Vector3d(1, 1, 1).normalized();
  CHECK(std::hypot(lambert(h, true).x(), lambert(h, true).y()) == Approx(0).margin(1e-12));
  CHECK(std::hypot(lambert(-h, false).x(), lambert(-h, false).y()) == Approx(0).margin(1e-12));
  const auto rim = lambert(Eigen::Vector3d(2, -1, -1).normalized(), true);
  CHECK(rim.x() == Approx(0).margin(1e-12));
  CHECK(rim.y() == Approx(1));
  // A cap of 60° holds half of the hemisphere, so its radius is √½.
  const Eigen::Vector3d up = Eigen::Vector3d(2, -1, -1).normalized();
  const auto cap = lambert(std::cos(sim::radians(60)) * h + std::sin(sim::radians(60)) * up, true);
  CHECK(cap.y() == Approx(std::sqrt(0.5)));
}

TEST_CASE("places and directions are each other's inverse in both discs") {
  for (const bool towards : {true, false})
    for (const QPointF place : {QPointF(0.3, -0.4), QPointF(-0.9, 0.1), QPointF(0, 0)}) {
      const auto direction = direction_at(place, towards);
      CHECK(direction.norm() == Approx(1));
      const auto back = lambert(direction, towards);
      CHECK(back.x() == Approx(place.x()).margin(1e-12));
      CHECK(back.y() == Approx(place.y()).margin(1e-12));
    }
  CHECK(direction_at(lambert(Eigen::Vector3d::Unit(1), true), true)(1) == Approx(1));
}

TEST_CASE("the unstable region lies in the disc of unloading, its border at the cells' edges") {
  const Drawing drawing = sphere_figure(directions(), test::subject());
  REQUIRE(drawing.plot);
  std::vector<QCPColorMap*> maps;
  for (int i = 0; i < drawing.plot->plottableCount(); ++i)
    if (auto* map = qobject_cast<QCPColorMap*>(drawing.plot->plottable(i))) maps.push_back(map);
  REQUIRE(maps.size() == 2);
  const auto at = [&](int disc, double x, double y) {
    return maps.at(static_cast<std::size_t>(disc))->data()->data(x, y);
  };
  CHECK(at(0, 0, 0) == 0.6);
  CHECK(at(1, 0, 0) == -0.4);
  const double border = std::sqrt(1 - std::cos(sim::radians(30)));
  CHECK(at(1, border - 0.06, 0) == -0.4);
  CHECK(at(1, border + 0.06, 0) == 0.6);
  CHECK(test::contains(drawing.caption, "of 1500 directions have W₂ < 0"));
  CHECK(test::words_are_readable(*drawing.plot));
  CHECK(test::words_of(*drawing.plot).size() == 8);
}

TEST_CASE("plane strain of an elastic answer is the great circle across axis 2") {
  const Drawing drawing = sphere_figure(directions(), test::subject());
  int points = 0;
  for (const auto* curve : test::curves_in(*drawing.plot, kGreen)) {
    const bool towards = curve->keyAxis() == drawing.plot->axisRect(0)->axis(QCPAxis::atBottom);
    for (const auto& point : *curve->data()) {
      if (!std::isfinite(point.key)) continue;
      ++points;
      CHECK(direction_at({point.key, point.value}, towards)(1) == Approx(0).margin(2e-3));
    }
  }
  CHECK(points > 200);
}

TEST_CASE("directions without an answer are grey; without any answer there is no figure") {
  auto all = directions();
  for (auto& d : all) d.answered = d.direction.sum() > 0;
  const Drawing drawing = sphere_figure(all, test::subject());
  for (int i = 0; i < drawing.plot->plottableCount(); ++i)
    if (auto* map = qobject_cast<QCPColorMap*>(drawing.plot->plottable(i)))
      if (map->keyAxis() != drawing.plot->xAxis) CHECK(std::isnan(map->data()->data(0, 0)));
  for (auto& d : all) d.answered = false;
  CHECK_FALSE(sphere_figure(all, test::subject()).plot);
}

TEST_CASE("the line W2 = 0 runs between the directions, not along the edges of their cells") {
  // W₂ = 0 on the cone of 30° about isotropic unloading, in directions 5.2° apart.
  auto all = directions();
  for (auto& d : all) d.normalised = std::cos(sim::radians(30)) + d.direction.sum() / std::sqrt(3);
  const Drawing drawing = sphere_figure(all, test::subject());
  int points = 0;
  for (const auto* curve : test::curves_in(*drawing.plot, kInk)) {
    if (curve->keyAxis() == drawing.plot->axisRect(0)->axis(QCPAxis::atBottom)) continue;
    if (curve->dataCount() < 20 || test::has_point(*curve, 1, 0, 1e-6)) continue;  // the rim
    for (const auto& point : *curve->data()) {
      if (!std::isfinite(point.key)) continue;
      ++points;
      const double cosine = -direction_at({point.key, point.value}, false).sum() / std::sqrt(3);
      CHECK(sim::degrees(std::acos(cosine)) == Approx(30).margin(0.3));
    }
  }
  CHECK(points > 100);
}

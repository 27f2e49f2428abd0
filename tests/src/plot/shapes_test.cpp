// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/shapes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"

using namespace triax::src;

TEST_CASE("a curve keeps its points in order and enters the legend only with a name") {
  auto plot = make_plot(200, 200);
  auto* curve = draw_curve(*plot->axisRect(), {{2, 1}, {1, 5}, {2, 3}}, line(kInk));
  REQUIRE(curve->dataCount() == 3);
  CHECK(curve->data()->at(1)->key == 1);
  CHECK(curve->data()->at(2)->value == 3);
  CHECK(plot->legend->itemCount() == 0);
  draw_curve(*plot->axisRect(), {}, line(kInk), "name");
  CHECK(test::legend_of(*plot) == std::vector<std::string>{"name"});
}

TEST_CASE("an area is closed and filled, markers have no line, an arrow ends at its tip") {
  auto plot = make_plot(200, 200);
  auto& rect = *plot->axisRect();
  auto* area = draw_area(rect, {{0, 0}, {1, 0}, {1, 1}}, kOrange, Qt::NoPen);
  CHECK(area->dataCount() == 4);
  CHECK(area->data()->at(3)->key == 0);
  CHECK(area->brush().color() == kOrange);
  lay_behind(*area);
  CHECK(area->layer()->name() == "grid");
  CHECK(draw_markers(rect, {{1, 1}}, QCPScatterStyle::ssDisc)->lineStyle() == QCPCurve::lsNone);
  draw_arrow(rect, {0, 0}, {3, 4}, line(kInk));
  const auto* arrow = qobject_cast<QCPItemLine*>(plot->item(0));
  REQUIRE(arrow != nullptr);
  CHECK(arrow->end->coords() == QPointF(3, 4));
  CHECK(arrow->head().style() != QCPLineEnding::esNone);
}

TEST_CASE("words stand outside of the middle") {
  CHECK(part_away({0, 0}, {1, 0}) == (Qt::AlignLeft | Qt::AlignVCenter));
  CHECK(part_away({0, 0}, {0, -2}) == (Qt::AlignHCenter | Qt::AlignTop));
  CHECK(part_away({1, 1}, {0, 2}) == (Qt::AlignRight | Qt::AlignBottom));
}

TEST_CASE("neighbouring curves differ in colour and in style") {
  for (std::size_t i = 0; i < 12; ++i) {
    CHECK(curve_pen(i).color() != curve_pen(i + 1).color());
    CHECK(curve_pen(i).style() != curve_pen(i + 1).style());
  }
}

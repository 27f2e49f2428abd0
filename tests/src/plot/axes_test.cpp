// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/axes.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"

using namespace triax::src;

TEST_CASE("equal ranges hold what was asked, about its middle, with one scale") {
  auto plot = make_plot(500, 300);
  style_axes(*plot->axisRect(), "x", "y");
  set_equal_ranges(*plot->axisRect(), {0, 100}, {-20, 60});
  const auto x = plot->xAxis->range(), y = plot->yAxis->range();
  const auto& rect = *plot->axisRect();
  CHECK(rect.width() / x.size() == Approx(rect.height() / y.size()).epsilon(0.01));
  CHECK(x.center() == Approx(50));
  CHECK(y.center() == Approx(20));
  CHECK(x.size() >= 100);
  CHECK(y.size() >= 80);
}

TEST_CASE("axes beside one another share a row above the legend") {
  auto plot = make_plot(800, 400);
  auto& beside = add_axes_beside(*plot);
  plot->addGraph()->setName("name");
  legend_below(*plot, 1);
  plot->replot();
  REQUIRE(plot->axisRectCount() == 2);
  CHECK(plot->axisRect(1) == &beside);
  CHECK(beside.left() > plot->axisRect(0)->right());
  CHECK(beside.top() == plot->axisRect(0)->top());
  CHECK(plot->legend->rect().top() > beside.bottom());
  hide_axes(beside);
  for (const auto* axis : beside.axes()) CHECK_FALSE(axis->visible());
}

TEST_CASE("axes in rows fill row by row, as many in each as was asked") {
  auto plot = make_plot(900, 600);
  const auto all = add_axes_in_rows(*plot, 5, 3);
  plot->replot();
  REQUIRE(all.size() == 5);
  CHECK(all[0] == plot->axisRect(0));
  CHECK(all[1]->left() > all[0]->right());
  CHECK(all[2]->top() == all[0]->top());
  CHECK(all[3]->top() > all[0]->bottom());
  CHECK(all[4]->left() == all[1]->left());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/point_labels.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "src/plot/axes.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "tests/src/plot/plot_contents.hpp"

using namespace triax::src;

namespace {

OwnPlot square_plot() {
  auto plot = make_plot(400, 400);
  plot->xAxis->setRange(0, 10);
  plot->yAxis->setRange(0, 10);
  return plot;
}

}  // namespace

TEST_CASE("labels of near points do not cover one another") {
  auto plot = square_plot();
  place_labels(*plot,
               {{5, 5, "first", kInk}, {5.2, 5.1, "second", kInk}, {4.9, 4.8, "third", kInk}});
  CHECK(test::words_of(*plot).size() == 3);
  CHECK(test::words_are_readable(*plot));
}

TEST_CASE("a label keeps off markers and words that stand there") {
  auto plot = square_plot();
  draw_markers(*plot->axisRect(), {{5.6, 5}}, QCPScatterStyle::ssCircle);
  write_text(*plot->axisRect(), {4.6, 5}, "there already", kInk, Qt::AlignRight | Qt::AlignVCenter);
  place_labels(*plot, {{5, 5, "label", kInk}});
  REQUIRE(test::words_of(*plot).size() == 2);
  CHECK(test::words_are_readable(*plot));
  const auto place = test::place_of(*test::words_of(*plot)[1]);
  CHECK_FALSE(place.contains(plot->xAxis->coordToPixel(5.6), plot->yAxis->coordToPixel(5)));
}

TEST_CASE("labels of the second axes stand beside their points there") {
  auto plot = square_plot();
  auto& beside = add_axes_beside(*plot);
  beside.axis(QCPAxis::atBottom)->setRange(0, 1);
  beside.axis(QCPAxis::atLeft)->setRange(0, 1);
  place_labels(beside, {{0.5, 0.5, "here", kInk}});
  REQUIRE(test::words_of(*plot).size() == 1);
  const auto at = test::place_of(*test::words_of(*plot)[0]).center();
  CHECK(QRectF(beside.rect()).contains(at));
}

TEST_CASE("a line with a gap, or one that runs far beyond the plot, leaves room for its label") {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  auto plot = square_plot();
  auto* curve = new QCPCurve(plot->xAxis, plot->yAxis);  // the plot owns it
  curve->setData({0, 1, 2, 3, 4}, {1, 5, unknown, 5, 1e12}, {0, 4, unknown, 6, 1e12});
  place_labels(*plot, {{5, 5, "label", kInk}});
  CHECK(test::words_of(*plot).size() == 1);
  CHECK(test::words_are_readable(*plot));
}

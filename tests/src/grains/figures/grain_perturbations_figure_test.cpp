// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/figures/grain_perturbations_figure.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;

TEST_CASE("a panel each, with the share on the left and the energy on the right axis") {
  const Drawing drawing = grain_perturbations_figure(
      {{"ES_a: at rest", test::decaying(1.02)}, {"ES_b: collapsed", test::decaying(0.05)}},
      {"sample", ""});
  REQUIRE(drawing.plot);
  const QCustomPlot& plot = *drawing.plot;
  REQUIRE(plot.axisRectCount() == 2);
  CHECK(test::any_has_point(plot, 100, 1.02, 1e-9));  // ms
  CHECK(test::any_has_point(plot, 100, 0.05, 1e-9));
  CHECK(test::any_has_point(plot, 100, 1e-4, 1e-9));
  const auto& right = *plot.axisRect(1)->axis(QCPAxis::atRight);
  CHECK(right.scaleType() == QCPAxis::stLogarithmic);
  CHECK(right.tickLabels());
  CHECK(plot.axisRect(0)->axis(QCPAxis::atRight)->scaleType() == QCPAxis::stLinear);
  CHECK(plot.axisRect(1)->axis(QCPAxis::atTop)->label().toStdString() == "ES_b: collapsed");
  for (const auto* curve : test::curves_of(plot))
    if (test::has_point(*curve, 100, 1e-4, 1e-9)) CHECK(curve->valueAxis() == &right);
}

TEST_CASE("seconds where one lasts a second, rows of three, and no panel without a point") {
  auto slow = test::decaying(1.02);
  slow.back().time_s = 1.5;
  const Drawing drawing = grain_perturbations_figure(
      {{"a", slow}, {"b", slow}, {"none", {}}, {"c", slow}, {"d", slow}}, {"sample", ""});
  REQUIRE(drawing.plot->axisRectCount() == 4);
  CHECK(test::any_has_point(*drawing.plot, 1.5, 1.02, 1e-9));
  drawing.plot->replot();
  CHECK(drawing.plot->axisRect(2)->top() == drawing.plot->axisRect(0)->top());
  CHECK(drawing.plot->axisRect(3)->top() > drawing.plot->axisRect(0)->bottom());
  CHECK_FALSE(grain_perturbations_figure({{"none", {}}}, {"sample", ""}).plot);
}

TEST_CASE("an energy of zero is a gap on a logarithmic axis") {
  auto points = test::decaying(0.05);
  points[0].kinetic_energy_j = 0;
  const Drawing drawing = grain_perturbations_figure({{"a", points}}, {"sample", ""});
  for (const auto* curve : test::curves_of(*drawing.plot))
    CHECK_FALSE(test::has_point(*curve, 0, 0, 1e-12));
}

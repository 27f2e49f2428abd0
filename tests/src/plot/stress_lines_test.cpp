// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/stress_lines.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"

using namespace triax::src;

namespace {

QCPGraphDataContainer::const_iterator end_of(QCustomPlot& plot, double eta) {
  draw_instability_line(plot, eta);
  return plot.graph(plot.graphCount() - 1)->data()->constEnd() - 1;
}

}  // namespace

TEST_CASE("a line ends at the border and keeps its slope, in compression and in extension") {
  const OwnPlot plot = make_plot(400, 400);
  plot->xAxis->setRange(0, 300);
  plot->yAxis->setRange(-60, 90);
  for (const double eta : {0.2, 0.6, -0.1, -0.5}) {
    const auto end = end_of(*plot, eta);
    INFO(eta);
    CHECK(end->value == Approx(eta * end->key));
    const bool at_side = end->key == Approx(300);
    CHECK((at_side || end->value == Approx(90) || end->value == Approx(-60)));
    CHECK(end->value <= 90.001);
    CHECK(end->value >= -60.001);
  }
}

TEST_CASE("draw_mohr_coulomb_line: cohesion lifts the line, up to the border of the plot") {
  const OwnPlot plot = make_plot(400, 400);
  plot->xAxis->setRange(0, 300);
  plot->yAxis->setRange(0, 90);
  draw_mohr_coulomb_line(*plot, 1.2, 30);
  REQUIRE(plot->graphCount() == 1);
  const auto& data = *plot->graph(0)->data();
  CHECK(data.constBegin()->value == Approx(30));
  CHECK((data.constEnd() - 1)->value == Approx(90));
  CHECK((data.constEnd() - 1)->key == Approx(50));
  CHECK(plot->graph(0)->name().contains("k = 30.0 kPa"));
  draw_mohr_coulomb_line(*plot, 1.2, 100);
  CHECK(plot->graphCount() == 1);
}

TEST_CASE("one line is told by its slope, two by what each is of") {
  CHECK(instability_words({0.54}) == "η = 0.54");
  CHECK(instability_words({0.54, -0.38}) == "η = 0.54 in compression, -0.38 in extension");
}

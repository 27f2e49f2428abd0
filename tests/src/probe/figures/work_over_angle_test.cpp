// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/work_over_angle.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// Spans of the areas that are filled, degrees.
std::vector<QCPRange> shaded(const QCustomPlot& plot) {
  std::vector<QCPRange> spans;
  for (const auto* curve : test::curves_of(plot))
    if (curve->brush().style() != Qt::NoBrush && curve->dataCount() > 0) {
      bool found = false;
      spans.push_back(curve->getKeyRange(found));
    }
  return spans;
}

}  // namespace

TEST_CASE("the cones are shaded from edge to edge, a curve a state") {
  const auto circle = test::inl2_circle(0.7);
  const Drawing drawing = work_over_angle(
      {{"η = 0.50", test::inl2_circle(0.5)}, {"η = 0.70", circle}}, test::subject());
  REQUIRE(drawing.plot);
  const auto spans = shaded(*drawing.plot);
  REQUIRE(spans.size() == 1);
  CHECK(spans[0].lower == Approx(sim::degrees(circle.cones[0].from)));
  CHECK(spans[0].upper == Approx(sim::degrees(circle.cones[0].to)));
  CHECK(spans[0].lower == Approx(208).margin(0.5));
  CHECK(drawing.plot->xAxis->range() == QCPRange(0, 360));
  CHECK(test::any_has_point(*drawing.plot, sim::degrees(circle.least.angle),
                            circle.least.normalised, 1e-9));
  CHECK(test::any_has_point(*drawing.plot, 360, circle.probes.front().normalised, 1e-9));
  CHECK(test::contains(drawing.caption, "η = 0.70 207.8° to"));
  CHECK(test::in_legend(*drawing.plot, "η = 0.50"));
}

TEST_CASE("a cone that passes zero degrees is shaded at both ends") {
  auto circle = test::invented_circle([](double a) { return std::cos(a) > 0.95 ? -0.5 : 0.5; });
  circle.cones = {{sim::radians(345), sim::radians(375), {}}};
  const auto spans = shaded(*work_over_angle({{"", circle}}, test::subject()).plot);
  REQUIRE(spans.size() == 2);
  CHECK(spans[0].lower == Approx(345));
  CHECK(spans[0].upper == Approx(360));
  CHECK(spans[1].lower == Approx(0).margin(1e-9));
  CHECK(spans[1].upper == Approx(15));
}

TEST_CASE("without a cone the caption says so; without an answer there is no figure") {
  auto circle = test::invented_circle([](double) { return 0.5; });
  CHECK(test::contains(work_over_angle({{"", circle}}, test::subject()).caption,
                       "no direction has W₂ < 0"));
  for (auto& probe : circle.probes) probe.answered = false;
  CHECK_FALSE(work_over_angle({{"", circle}}, test::subject()).plot);
}

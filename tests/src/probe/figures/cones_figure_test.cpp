// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/cones_figure.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

namespace {

const Subject kSubject = test::subject();

ConesPicture one_fan() {
  ConesPicture picture;
  picture.limit_stress_ratio = 1.2;
  picture.states = {{{100e3, 60e3}, {{sim::radians(210), sim::radians(240)}}}, {{100e3, 30e3}, {}}};
  return picture;
}

std::vector<QCPCurve*> fans(const QCustomPlot& plot) {
  auto curves = test::curves_in(plot, kVermilion);
  std::erase_if(curves, [](const auto* curve) { return curve->brush().style() == Qt::NoBrush; });
  return curves;
}

/// From the first point of a fan, its tip, to its i-th.
QPointF edge(const QCPCurve& fan, int i) {
  const auto tip = *fan.data()->at(0), end = *fan.data()->at(i);
  return {end.key - tip.key, end.value - tip.value};
}

}  // namespace

TEST_CASE("increments in the p'-q plane are those of the definitions of p' and q") {
  // dσ₁ alone: dp′ = 1/3, dq = 1. dσ₃ = 1/√2 alone: dp′ = √2/3, dq = −1/√2.
  CHECK(increment(sim::radians(90), StressAxes::p_q).x() == Approx(1.0 / 3));
  CHECK(increment(sim::radians(90), StressAxes::p_q).y() == Approx(1));
  CHECK(increment(0, StressAxes::p_q).x() == Approx(std::numbers::sqrt2 / 3));
  CHECK(increment(0, StressAxes::p_q).y() == Approx(-1 / std::numbers::sqrt2));
  // Isotropic unloading of unit norm: dσ = −1/√3 each.
  const auto unloading = increment(sim::kIsotropicUnloading, StressAxes::p_q);
  CHECK(unloading.x() == Approx(-1 / std::sqrt(3)));
  CHECK(unloading.y() == Approx(0).margin(1e-12));
  CHECK(increment(sim::radians(30), StressAxes::rendulic).y() == Approx(0.5));
}

TEST_CASE("states in the Rendulic plane: sigma1' over sqrt2 sigma3'") {
  const auto at = position({100e3, 60e3}, StressAxes::rendulic);
  CHECK(at.x() == Approx(std::numbers::sqrt2 * 80e3));
  CHECK(at.y() == Approx(140e3));
}

TEST_CASE("a fan's edges point along the transformed directions of its cone") {
  for (const auto plane : {StressAxes::p_q, StressAxes::rendulic}) {
    const Drawing drawing = cones_figure(one_fan(), kSubject, plane);
    REQUIRE(drawing.plot);
    const auto found = fans(*drawing.plot);
    REQUIRE(found.size() == 1);
    const auto& fan = *found[0];
    const QPointF tip = position({100, 60}, plane);
    CHECK(fan.data()->at(0)->key == Approx(tip.x()));
    CHECK(fan.data()->at(0)->value == Approx(tip.y()));
    // The last point closes the polygon; the one before it is the end of the arc.
    const auto first = edge(fan, 1), last = edge(fan, fan.dataCount() - 2);
    const auto along = [](const QPointF& a, const QPointF& b) {
      return QPointF::dotProduct(a, b) / std::hypot(a.x(), a.y()) / std::hypot(b.x(), b.y());
    };
    CHECK(along(first, increment(sim::radians(210), plane)) == Approx(1).epsilon(1e-9));
    CHECK(along(last, increment(sim::radians(240), plane)) == Approx(1).epsilon(1e-9));
  }
  // By hand: 210° is √2 dσ₃ = −√3/2, dσ₁ = −1/2, so dp′ = −1/6 − √6/6 and dq = −1/2 + √6/4.
  const Drawing drawing = cones_figure(one_fan(), kSubject, StressAxes::p_q);
  const auto side = edge(*fans(*drawing.plot)[0], 1);
  CHECK(side.y() / side.x() ==
        Approx((-0.5 + std::sqrt(6) / 4) / (-1.0 / 6 - std::sqrt(6) / 6)).epsilon(1e-6));
}

TEST_CASE("both planes keep one scale on both axes and hold all states and the origin") {
  for (const auto plane : {StressAxes::p_q, StressAxes::rendulic}) {
    const Drawing drawing = cones_figure(one_fan(), kSubject, plane);
    const auto& rect = *drawing.plot->axisRect();
    const auto x = drawing.plot->xAxis->range(), y = drawing.plot->yAxis->range();
    CHECK(rect.width() / x.size() == Approx(rect.height() / y.size()).epsilon(0.01));
    CHECK(x.lower == 0);
    CHECK(y.lower == 0);
    const auto at = position({100, 60}, plane);
    CHECK(x.contains(at.x()));
    CHECK(y.contains(at.y()));
  }
}

TEST_CASE("two cones of a state are two fans; extension lies below the axis") {
  auto picture = one_fan();
  picture.states[0].cones.push_back({sim::radians(300), sim::radians(310)});
  picture.states.push_back({{100e3, -40e3}, {}});
  const Drawing drawing = cones_figure(picture, kSubject, StressAxes::p_q);
  CHECK(fans(*drawing.plot).size() == 2);
  CHECK(drawing.plot->yAxis->range().contains(-40));
}

TEST_CASE("arrows of tests start at their states; their names cover nothing") {
  auto picture = one_fan();
  picture.tests = {{"27", {190e3, 105e3}, sim::radians(223), false},
                   {"58", {140e3, 80e3}, sim::kIsotropicUnloading, true}};
  const Drawing drawing = cones_figure(picture, kSubject, StressAxes::p_q);
  std::vector<const QCPItemLine*> arrows;
  for (int i = 0; i < drawing.plot->itemCount(); ++i)
    if (const auto* arrow = qobject_cast<QCPItemLine*>(drawing.plot->item(i)))
      arrows.push_back(arrow);
  REQUIRE(arrows.size() == 2);
  CHECK(arrows[1]->start->coords() == QPointF(140, 80));
  CHECK(arrows[1]->end->coords().y() == Approx(80));  // dq = 0
  CHECK(arrows[1]->end->coords().x() < 140);
  CHECK(test::words_of(*drawing.plot).size() == 2);
  CHECK(test::words_are_readable(*drawing.plot));
  CHECK(test::in_legend(*drawing.plot, "recorded"));
  CHECK(test::in_legend(*drawing.plot, "simulated"));
  CHECK(test::contains(drawing.caption, "increments of tests"));
}

TEST_CASE("the caption counts the states; nothing is drawn of nothing") {
  CHECK(
      test::contains(cones_figure(one_fan(), kSubject, StressAxes::p_q).caption, "1 of 2 states"));
  CHECK_FALSE(cones_figure({}, kSubject, StressAxes::p_q).plot);
  const auto sectors = sectors_of(test::inl2_circle(0.6));
  REQUIRE(sectors.size() == 1);
  CHECK(sim::degrees(sectors[0].from) == Approx(215).margin(0.5));
}

TEST_CASE("M is of compression: named so beside extension, left out without compression") {
  auto picture = one_fan();
  CHECK(test::in_legend(*cones_figure(picture, kSubject, StressAxes::p_q).plot,
                        "limit line, M = 1.20"));
  picture.states.push_back({{100e3, -40e3}, {}});
  CHECK(test::in_legend(*cones_figure(picture, kSubject, StressAxes::p_q).plot,
                        "limit line in compression, M = 1.20"));
  picture.states = {{{100e3, -40e3}, {}}};
  CHECK_FALSE(
      test::in_legend(*cones_figure(picture, kSubject, StressAxes::p_q).plot, "limit line"));
}

TEST_CASE("the law's own limit states are drawn in the place of M, and its instability line") {
  auto picture = one_fan();
  picture.limits = {{{50e3, 60e3}, {150e3, 175e3}}};
  picture.instability_lines = {{{50e3, 28e3}, {150e3, 85e3}}};
  const Drawing drawing = cones_figure(picture, kSubject, StressAxes::p_q);
  CHECK_FALSE(test::in_legend(*drawing.plot, "M ="));
  CHECK(test::in_legend(*drawing.plot, "plastic limit"));
  CHECK(test::any_has_point(*drawing.plot, 150, 175, 1e-9));
  CHECK(test::in_legend(*drawing.plot, "instability line"));
  CHECK(test::any_has_point(*drawing.plot, 150, 85, 1e-9));
  CHECK_FALSE(
      test::in_legend(*cones_figure(one_fan(), kSubject, StressAxes::p_q).plot, "instability"));
}

TEST_CASE("names of tests stand on no ring of a state") {
  ConesPicture picture;
  for (int p = 1; p <= 9; ++p)
    for (int q = 0; q <= 9; ++q) picture.states.push_back({{100e3 * p, 100e3 * q}, {}});
  picture.tests = {{"CSD 58", {155e3, 90e3}, sim::kIsotropicUnloading, true},
                   {"CSU 27", {842e3, 450e3}, sim::kIsotropicUnloading, true}};
  const Drawing drawing = cones_figure(picture, kSubject, StressAxes::p_q);
  const auto words = test::words_of(*drawing.plot);
  CHECK(words.size() == 2);
  drawing.plot->replot();
  for (const auto* word : words)
    for (const auto& at : picture.states)
      CHECK_FALSE(test::place_of(*word).contains(
          QPointF(drawing.plot->xAxis->coordToPixel(at.state.p * 1e-3),
                  drawing.plot->yAxis->coordToPixel(at.state.q * 1e-3))));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/circular_diagram.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;

namespace {

double radius(const QCPCurveData& point) { return std::hypot(point.key, point.value); }

std::vector<NamedCircle> three_states() {
  return {{"η = 0.50", test::inl2_circle(0.5)},
          {"η = 0.60", test::inl2_circle(0.6)},
          {"η = 0.70", test::inl2_circle(0.7)}};
}

}  // namespace

TEST_CASE("the constant keeps every radius clear of zero") {
  const auto at = [](double least) {
    return circular_constant(
        {{"", test::invented_circle([least](double a) { return a > 3 ? least : 0.9; })}});
  };
  CHECK(at(0.4) == 0.5);
  CHECK(at(-0.15) == 0.5);
  CHECK(at(-0.2) == 0.5);
  CHECK(at(-0.25) == 1);
  CHECK(at(-1) == 1.5);
}

TEST_CASE("negative W2 is vermilion within the circle of the constant, positive blue outside") {
  const auto circles = three_states();
  const double constant = circular_constant(circles);
  const Drawing drawing = circular_diagram(circles, test::subject());
  REQUIRE(drawing.plot);
  const auto negative = test::curves_in(*drawing.plot, kVermilion);
  const auto positive = test::curves_in(*drawing.plot, kBlue);
  CHECK(negative.size() == 2);  // none at η = 0.5
  CHECK(positive.size() == 5);  // one, and two of each state with a cone
  for (const auto* curve : negative)
    for (const auto& point : *curve->data()) {
      CHECK(radius(point) <= constant + 1e-9);
      CHECK(radius(point) > 0);
    }
  for (const auto* curve : positive)
    for (const auto& point : *curve->data()) {
      CHECK(radius(point) >= constant - 1e-9);
      CHECK(radius(point) <= constant + 1);
    }
  CHECK(negative[0]->pen().style() != negative[1]->pen().style());
  CHECK(negative[0]->pen().widthF() > positive[0]->pen().widthF());
}

TEST_CASE("a probe lies in its direction at its value and the constant") {
  const auto circle = test::invented_circle([](double a) { return 0.3 * std::cos(a); });
  const Drawing drawing = circular_diagram({{"", circle}}, test::subject());
  CHECK(test::any_has_point(*drawing.plot, 1.3, 0, 1e-9));
  CHECK(test::any_has_point(*drawing.plot, -0.7, 0, 1e-9));
  CHECK(test::any_has_point(*drawing.plot, 0, 1, 1e-9));
  // Isotropic unloading, to the rim.
  CHECK(test::any_has_point(*drawing.plot, -2 * std::sqrt(2.0 / 3), -2 * std::sqrt(1.0 / 3), 1e-9));
}

TEST_CASE("caption and legend say the constant, the states and that it is simulated") {
  const Drawing drawing = circular_diagram(three_states(), test::subject());
  CHECK(test::contains(drawing.caption, "+ 1,"));
  CHECK(test::contains(drawing.caption, "η = 0.50, η = 0.60 and η = 0.70"));
  CHECK(test::contains(drawing.caption, "Simulated with inl2/S28-general, p′ = 70 kPa"));
  CHECK(test::in_legend(*drawing.plot, "η = 0.60"));
  CHECK(test::in_legend(*drawing.plot, "215.26°"));
  CHECK(test::words_are_readable(*drawing.plot));
  auto strain = test::subject();
  strain.kind = sim::ProbeKind::strain;
  CHECK_FALSE(test::in_legend(
      *circular_diagram({{"", test::inl2_circle(0.6, sim::ProbeKind::strain)}}, strain).plot,
      "unloading"));
}

TEST_CASE("one unit is as long on both axes, and the whole circle is within them") {
  const Drawing drawing = circular_diagram(three_states(), test::subject());
  const auto& rect = *drawing.plot->axisRect();
  const auto x = drawing.plot->xAxis->range(), y = drawing.plot->yAxis->range();
  CHECK(rect.width() / x.size() == Approx(rect.height() / y.size()).epsilon(1e-9));
  CHECK(x.upper > 2);
  CHECK(y.upper > 2);
}

TEST_CASE("the polar diagram has the size of W2 as radius and its sign as colour") {
  const auto circle = test::invented_circle([](double a) { return std::cos(a); });
  const Drawing plain = polar_diagram({{"", circle}}, test::subject());
  REQUIRE(plain.plot);
  const auto negative = test::curves_in(*plain.plot, kVermilion);
  REQUIRE(negative.size() == 1);
  CHECK(test::has_point(*negative[0], -1, 0, 1e-9));
}

TEST_CASE("nothing answered, nothing drawn") {
  auto circle = test::invented_circle([](double) { return 1.0; });
  for (auto& probe : circle.probes) probe.answered = false;
  CHECK_FALSE(circular_diagram({{"", circle}}, test::subject()).plot);
  CHECK_FALSE(polar_diagram({{"", circle}}, test::subject()).plot);
  CHECK_FALSE(circular_diagram({}, test::subject()).plot);
}

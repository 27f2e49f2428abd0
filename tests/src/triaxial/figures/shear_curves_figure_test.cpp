// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/shear_curves_figure.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax::src;
using namespace triax::study;

TEST_CASE("the whole of shear on the left, its beginning on the right") {
  const Drawing drawing = shear_curves_figure(shear_series({test::flow_test()}));
  REQUIRE(drawing.plot);
  REQUIRE(drawing.plot->axisRectCount() == 2);
  CHECK(test::any_has_point(*drawing.plot, 0.5, 60, 0.01));
  const auto right = drawing.plot->axisRect(1)->axis(QCPAxis::atBottom)->range();
  CHECK(right.upper == Approx(1.5));  // three times the strain at onset
  CHECK(drawing.plot->axisRect(0)->axis(QCPAxis::atBottom)->range().upper > 10);
  for (auto* plottable : drawing.plot->axisRect(1)->plottables())
    for (const auto& point : *qobject_cast<QCPCurve*>(plottable)->data())
      CHECK(point.key <= right.upper);
}

TEST_CASE("without a collapse the whole is enough; without states no figure") {
  const Drawing drawing = shear_curves_figure(shear_series({test::stable_test()}));
  REQUIRE(drawing.plot);
  CHECK(drawing.plot->axisRectCount() == 1);
  CHECK_FALSE(shear_curves_figure({}).plot);
}

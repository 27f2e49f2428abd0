// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/strains_over_p_figure.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax::src;
using namespace triax::study;

TEST_CASE("both strains over p′, not farther than some strains at onset") {
  const Drawing drawing = strains_over_p_figure(shear_beginnings({test::flow_test()}));
  REQUIRE(drawing.plot);
  REQUIRE(drawing.plot->axisRectCount() == 2);
  CHECK(test::any_has_point(*drawing.plot, 100, 0.5, 0.01));  // axial strain at onset
  CHECK(test::any_has_point(*drawing.plot, 100, 0, 0.01));    // volumetric
  for (auto* plottable : drawing.plot->axisRect(0)->plottables())
    for (const auto& point : *qobject_cast<QCPCurve*>(plottable)->data())
      CHECK(point.value <= 1.25 + 1e-9);
  CHECK(drawing.caption.find("up to ε₁ = 1.2") != std::string::npos);
}

TEST_CASE("strains over p′ of nothing are no figure") {
  CHECK_FALSE(strains_over_p_figure({}).plot);
  auto nothing = test::flow_test();
  nothing.curves = {};
  CHECK_FALSE(strains_over_p_figure(shear_beginnings({nothing})).plot);
}

TEST_CASE("a volume that is shut in has an axis that a reader believes") {
  auto test = test::flow_test();
  for (auto& s : test.curves.states) s.volumetric_strain = 0;
  const Drawing drawing = strains_over_p_figure(shear_beginnings({test}));
  REQUIRE(drawing.plot);
  CHECK(drawing.plot->axisRect(1)->axis(QCPAxis::atLeft)->range().size() >= 0.1);
}

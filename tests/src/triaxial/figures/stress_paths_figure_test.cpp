// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/stress_paths_figure.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax::src;
using namespace triax::study;

TEST_CASE("each test has its path, each collapse its ring, and one line fits them") {
  const Drawing drawing = stress_paths_figure(
      shear_series({test::flow_test(), test::simulated_test(), test::stable_test()}));
  REQUIRE(drawing.plot);
  CHECK(test::any_has_point(*drawing.plot, 140, 0, 0.5));
  CHECK(test::any_has_point(*drawing.plot, 100, 60, 0.01));
  CHECK(test::any_has_point(*drawing.plot, 200, 110, 0.01));
  CHECK(test::in_legend(*drawing.plot, "stable"));
  CHECK(test::in_legend(*drawing.plot, "instability line (η = 0.56"));
  CHECK(test::in_legend(*drawing.plot, "Mohr-Coulomb line (M = 1.25"));
  CHECK(drawing.caption.find("sim-26 and stable") != std::string::npos);
}

TEST_CASE("without a collapse there are paths only; without states no figure") {
  const Drawing drawing = stress_paths_figure(shear_series({test::stable_test()}));
  REQUIRE(drawing.plot);
  CHECK_FALSE(test::in_legend(*drawing.plot, "instability"));
  CHECK(drawing.caption.find("no collapse point") != std::string::npos);
  auto nothing = test::stable_test();
  nothing.curves = {};
  CHECK_FALSE(stress_paths_figure(shear_series({nothing})).plot);
  CHECK_FALSE(stress_paths_figure({}).plot);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/stress_increments_figure.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"

using namespace triax::src;
using namespace triax::study;

namespace {
const std::vector<CollapseIncrement> kThree = {{"a", "ICU", 100e3, 60e3, -2, 0},
                                               {"b", "CSD", 200e3, 110e3, -1e3, -100},
                                               {"c", "", 300e3, 170e3, -5, 1}};
}

TEST_CASE("an arrow of one length points along each increment, on axes of one scale") {
  const Drawing drawing = stress_increments_figure(kThree, "simulated: x");
  REQUIRE(drawing.plot);
  auto& plot = *drawing.plot;
  plot.replot();
  const auto& rect = *plot.axisRect();
  CHECK(plot.xAxis->range().size() / rect.width() ==
        Approx(plot.yAxis->range().size() / rect.height()).epsilon(0.01));
  std::vector<double> lengths;
  std::vector<double> slopes;
  for (int i = 0; i < plot.itemCount(); ++i)
    if (const auto* arrow = qobject_cast<QCPItemLine*>(plot.item(i))) {
      const QPointF way = arrow->end->coords() - arrow->start->coords();
      lengths.push_back(std::hypot(way.x(), way.y()));
      slopes.push_back(way.y() / way.x());
      CHECK(way.x() < 0);
    }
  REQUIRE(lengths.size() == 3);
  CHECK(lengths[1] == Approx(lengths[0]));
  CHECK(slopes[0] == Approx(0).margin(1e-12));
  CHECK(slopes[1] == Approx(0.1));
  CHECK(slopes[2] == Approx(-0.2));
  CHECK(test::in_legend(plot, "other"));
}

TEST_CASE("the caption says how far directions lie from isotropic unloading") {
  const auto caption = stress_increments_figure(kThree, "").caption;
  CHECK(caption.find("between -11° and +6°") != std::string::npos);
  CHECK(caption.find("3 tests") != std::string::npos);
}

TEST_CASE("no increments, no figure") { CHECK_FALSE(stress_increments_figure({}, "").plot); }

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/angle_axis.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"

using namespace triax;
using namespace triax::src;

namespace {

std::vector<QCPRange> spans(double from, double to) {
  auto plot = make_plot(400, 300);
  shade_directions(*plot->axisRect(), from, to, kVermilion, "name");
  std::vector<QCPRange> found;
  for (const auto* curve : test::curves_of(*plot)) {
    bool any = false;
    found.push_back(curve->getKeyRange(any));
  }
  CHECK(test::legend_of(*plot).size() == 1);
  return found;
}

}  // namespace

TEST_CASE("the axis goes once around and says what is imposed") {
  auto plot = make_plot(600, 300);
  style_angle_axes(*plot->axisRect(), sim::ProbePlane::axisymmetric, sim::ProbeKind::stress, "y");
  CHECK(plot->xAxis->range() == QCPRange(0, 360));
  CHECK(plot->xAxis->label() == "direction α of the stress increment from √2 dσ₃ (°)");
  CHECK(plot->yAxis->label() == "y");
  style_angle_axes(*plot->axisRect(), sim::ProbePlane::plane_strain, sim::ProbeKind::strain, "y");
  CHECK(plot->xAxis->label() == "direction α of the strain increment from dε₃ (°)");
}

TEST_CASE("directions that pass 0° are shaded at both ends, on either side") {
  CHECK(spans(10, 20) == std::vector<QCPRange>{{10, 20}});
  CHECK(spans(345, 375) == std::vector<QCPRange>{{345, 360}, {0, 15}});
  CHECK(spans(-5, 15) == std::vector<QCPRange>{{355, 360}, {0, 15}});
}

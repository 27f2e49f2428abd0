// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/energy_axis.hpp"

#include <catch2/catch.hpp>

#include "src/plot/drawing.hpp"

using namespace triax::src;

TEST_CASE("energies of two decades or more have a logarithmic axis of whole decades") {
  EnergyRange range;
  for (const double energy : {2e-9, 0.0, 3e-6}) range.add(energy);
  CHECK(range.logarithmic());
  auto plot = make_plot(300, 200);
  range.apply(*plot->yAxis);
  CHECK(plot->yAxis->scaleType() == QCPAxis::stLogarithmic);
  CHECK(plot->yAxis->range().lower == Approx(1e-9));
  CHECK(plot->yAxis->range().upper == Approx(1e-5));
}

TEST_CASE("energies close together have a linear axis from zero; without one it is not empty") {
  EnergyRange range;
  auto plot = make_plot(300, 200);
  range.apply(*plot->yAxis);
  CHECK(plot->yAxis->range().size() > 0);
  range.add(1e-4);
  range.add(5e-5);
  CHECK_FALSE(range.logarithmic());
  range.apply(*plot->yAxis);
  CHECK(plot->yAxis->scaleType() == QCPAxis::stLinear);
  CHECK(plot->yAxis->range().lower == 0);
  CHECK(plot->yAxis->range().upper > 1e-4);
}

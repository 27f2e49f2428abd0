// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/sheet_figures.hpp"

#include <qcustomplot.h>

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_sheets.hpp"

using namespace triax;
using namespace triax::src;

namespace {

std::vector<std::string> names(const std::vector<SheetFigure>& figures) {
  std::vector<std::string> all;
  for (const auto& figure : figures) all.push_back(figure.name);
  return all;
}

const QCustomPlot& plot_of(const std::vector<SheetFigure>& figures, const std::string& name) {
  const auto found = std::ranges::find(figures, name, &SheetFigure::name);
  REQUIRE(found != figures.end());
  return *found->drawing.plot;
}

int dotted_curves(const QCustomPlot& plot) {
  int count = 0;
  for (const auto* curve : test::curves_in(plot, kBlue))
    count += curve->pen().style() == Qt::DotLine ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("an undrained test without a pore pressure shows p' in place of a volume that is zero") {
  auto test = test::flow_test();
  const auto with_u = names(sheet_figures(test::sheet_of(test)));
  CHECK(std::ranges::count(with_u, "u") == 1);
  for (auto& s : test.curves.states) s.pore_pressure = lab::kMissing;
  const auto without = names(sheet_figures(test::sheet_of(test)));
  CHECK(std::ranges::count(without, "p") == 1);
  CHECK(std::ranges::count(without, "volume") == 0);
}

TEST_CASE("where nothing was read between two states, the line is dotted") {
  auto test = test::flow_test();
  CHECK(dotted_curves(plot_of(sheet_figures(test::sheet_of(test)), "q")) == 0);
  auto& states = test.curves.states;  // it ran away between two readings of the logger
  states.erase(states.begin() + 320, states.end() - 1);
  test.curves.breaks.unread_steps = {states.back().reading};
  CHECK(dotted_curves(plot_of(sheet_figures(test::sheet_of(test)), "q")) == 1);
}

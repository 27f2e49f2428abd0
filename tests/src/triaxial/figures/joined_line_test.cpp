// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/joined_line.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::src;
using study::Join;

namespace {

/// Ten states with q of their number; those of 3 to 5 on a dead load cell.
std::vector<lab::State> ten_states() {
  std::vector<lab::State> states(10);
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i].reading = static_cast<std::int64_t>(i);
    states[i].q = i >= 3 && i <= 5 ? lab::kMissing : static_cast<double>(i);
  }
  return states;
}

JoinedLine q_line(const study::LineBreaks& breaks) {
  return joined_line(ten_states(), breaks, [](const lab::State& s) {
    return QPointF(static_cast<double>(s.reading), s.q);
  });
}

}  // namespace

TEST_CASE("joined_line: a faulty sensor leaves a gap, a value that is not known none") {
  CHECK(q_line({}).joins == std::vector<Join>(7, Join::solid));
  const auto line = q_line({.faults = {{lab::Quantity::axial_force, 3, 5}}});
  CHECK(line.points.size() == 7);
  CHECK(line.joins[3] == Join::none);
  CHECK(std::ranges::count(line.joins, Join::solid) == 6);
}

TEST_CASE("joined_line: an unread step is dotted wherever it ends between two points") {
  CHECK(q_line({.unread_steps = {8}}).joins[5] == Join::dotted);
  CHECK(q_line({.unread_steps = {4}}).joins[3] == Join::dotted);
}

TEST_CASE("draw_joined: solid parts and dots, with one entry in the legend") {
  auto plot = make_plot(300, 200);
  const auto line = q_line({.faults = {{lab::Quantity::axial_force, 3, 5}}, .unread_steps = {8}});
  draw_joined(*plot->axisRect(), line, triax::src::line(kBlue, 1.8), {}, "measured");
  const auto curves = test::curves_in(*plot, kBlue);
  REQUIRE(curves.size() == 4);
  CHECK(curves[0]->data()->size() == 3);  // 0 to 2
  CHECK(curves[1]->data()->size() == 2);  // 6, 7
  CHECK(curves[2]->pen().style() == Qt::DotLine);
  CHECK(curves[2]->data()->at(0)->key == 7);
  CHECK(curves[2]->data()->at(1)->key == 8);
  CHECK(curves[3]->data()->size() == 2);  // 8, 9
  CHECK(plot->legend->itemCount() == 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/series_plot.hpp"

#include <catch2/catch.hpp>

#include "src/plot/drawing.hpp"
#include "tests/src/plot/plot_contents.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

namespace {

SeriesTest named(const std::string& name) {
  SeriesTest test;
  test.name = name;
  return test;
}

}  // namespace

TEST_CASE("a range begins at 0 where only noise and its margin lie below, not where data do") {
  CHECK(from_zero({-5, 100}).lower == 0);
  CHECK(from_zero({-5, 100}).upper == 100);
  CHECK(from_zero({-50, 100}).lower == -50);
  CHECK(from_zero({3, 100}).lower == 3);
}

TEST_CASE("names are joined as in a sentence") {
  const std::vector<SeriesTest> tests = {named("A"), named("B"), named("C")};
  CHECK(names_of({tests[0]}) == "A");
  CHECK(names_of({tests[0], tests[1]}) == "A and B");
  CHECK(names_of(tests) == "A, B and C");
}

TEST_CASE("the legend has an entry a test, and the onset where there is one") {
  auto collapsed = make_plot(400, 300), stable = make_plot(400, 300);
  auto test = named("loose");
  test.onset = lab::Instant{};
  name_series(*collapsed->axisRect(), {test, named("stable")});
  name_series(*stable->axisRect(), {named("stable")});
  CHECK(src::test::legend_of(*collapsed) ==
        std::vector<std::string>{"loose", "stable", "onset of instability"});
  auto both = make_plot(400, 300);
  test.loss_of_control = lab::Instant{};
  name_series(*both->axisRect(), {test});
  CHECK(src::test::legend_of(*both) ==
        std::vector<std::string>{"loose", "onset of instability", "loss of control"});
  CHECK(src::test::legend_of(*stable) == std::vector<std::string>{"stable"});
}

TEST_CASE("states become points where both values are known, up to the first outside") {
  std::vector<lab::State> states(6);
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i].p_eff = 1000 * static_cast<double>(i);
    states[i].q = 2 * states[i].p_eff;
  }
  states[1].q = lab::kMissing;
  const StateValue p = [](const lab::State& s) { return s.p_eff * 1e-3; };
  const StateValue q = [](const lab::State& s) { return s.q * 1e-3; };
  CHECK(points_of(states, p, q) == Points{{0, 0}, {2, 4}, {3, 6}, {4, 8}, {5, 10}});
  CHECK(points_of(states, p, q, 3) == Points{{0, 0}, {2, 4}, {3, 6}});
}

TEST_CASE("a series keeps its ends and its corners, and drops what nobody sees") {
  auto plot = make_plot(400, 300);
  plot->xAxis->setRange(0, 100);
  plot->yAxis->setRange(0, 100);
  plot->replot();
  Points points;
  for (int i = 0; i <= 50; ++i) points.emplace_back(i, i);
  for (int i = 51; i <= 100; ++i) points.emplace_back(i, 100 - i);
  draw_series(*plot->axisRect(), {points, std::vector<study::Join>(points.size())}, 0, 1);
  const auto curves = src::test::curves_of(*plot);
  REQUIRE(curves.size() == 1);
  CHECK(curves.front()->dataCount() < 8);
  CHECK(src::test::has_point(*curves.front(), 50, 50, 1e-9));
  CHECK(src::test::has_point(*curves.front(), 100, 0, 1e-9));
}

TEST_CASE("a sweep has one look and one entry of the legend, and few of its names are told") {
  std::vector<triax::study::SeriesTest> many(150);
  for (auto& test : many) test.name = "CSU 26";
  auto plot = make_plot(620, 400);
  name_series(*plot->axisRect(), many);
  CHECK(triax::src::test::legend_of(*plot) == std::vector<std::string>{"150 tests"});
  CHECK(names_of(many) == "CSU 26, CSU 26, CSU 26 and 147 others");
}

#include "src/triaxial/figures/series_plot.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax::src;
using namespace triax::study;

TEST_CASE("a range begins at 0 where only noise and its margin lie below, not where data do") {
  CHECK(from_zero({-5, 100}).lower == 0);
  CHECK(from_zero({-5, 100}).upper == 100);
  CHECK(from_zero({-50, 100}).lower == -50);
  CHECK(from_zero({3, 100}).lower == 3);
}

TEST_CASE("names are joined as in a sentence") {
  auto a = test::flow_test(), b = test::flow_test(), c = test::flow_test();
  a.stored.header.name = "A";
  b.stored.header.name = "B";
  c.stored.header.name = "C";
  CHECK(names_of({a}) == "A");
  CHECK(names_of({a, b}) == "A and B");
  CHECK(names_of({a, b, c}) == "A, B and C");
}

TEST_CASE("the legend has an entry a test, and the onset where there is one") {
  auto collapsed = make_plot(400, 300), stable = make_plot(400, 300);
  name_series(*collapsed->axisRect(), {test::flow_test(), test::stable_test()});
  name_series(*stable->axisRect(), {test::stable_test()});
  CHECK(test::legend_of(*collapsed) ==
        std::vector<std::string>{"L<oose> 1", "stable", "onset of collapse"});
  CHECK(test::legend_of(*stable) == std::vector<std::string>{"stable"});
}

TEST_CASE("a series keeps its ends and its corners, and drops what nobody sees") {
  auto plot = make_plot(400, 300);
  plot->xAxis->setRange(0, 100);
  plot->yAxis->setRange(0, 100);
  plot->replot();
  Points points;
  for (int i = 0; i <= 50; ++i) points.emplace_back(i, i);
  for (int i = 51; i <= 100; ++i) points.emplace_back(i, 100 - i);
  draw_series(*plot->axisRect(), points, 0);
  const auto curves = test::curves_of(*plot);
  REQUIRE(curves.size() == 1);
  CHECK(curves.front()->dataCount() < 8);
  CHECK(test::has_point(*curves.front(), 50, 50, 1e-9));
  CHECK(test::has_point(*curves.front(), 100, 0, 1e-9));
}

TEST_CASE("pointers lead to the tests themselves") {
  const std::vector<TestResult> tests = {test::flow_test(), test::stable_test()};
  const auto pointers = pointers_to(tests);
  REQUIRE(pointers.size() == 2);
  CHECK(pointers[1] == &tests[1]);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/polar_frame.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"

using namespace triax;
using namespace triax::src;

TEST_CASE("angles run from the x axis towards the y axis") {
  CHECK(polar(2, sim::radians(90)).y() == Approx(2));
  CHECK(polar(2, sim::radians(180)).x() == Approx(-2));
  for (const auto& point : circle_of(1.5)) CHECK(std::hypot(point.x(), point.y()) == Approx(1.5));
}

TEST_CASE("a frame has twelve angles, its circles and the names of its axes, all readable") {
  auto plot = make_plot(620, 620);
  PolarFrame frame;
  frame.radius = 2;
  frame.circles = {{1, "one", line(kInk), "circle"}};
  frame.x_name = "√2 dσ₃";
  frame.y_name = "dσ₁";
  draw_polar_frame(*plot->axisRect(), frame);
  std::vector<std::string> words;
  for (const auto* word : test::words_of(*plot)) words.push_back(word->text().toStdString());
  CHECK(words.size() == 15);
  for (const std::string word : {"0°", "330°", "one", "√2 dσ₃", "dσ₁"})
    CHECK(std::ranges::count(words, word) == 1);
  CHECK(test::words_are_readable(*plot));
  CHECK(test::any_has_point(*plot, 1, 0, 1e-9));
  CHECK(test::any_has_point(*plot, 2, 0, 1e-9));
  CHECK(test::in_legend(*plot, "circle"));
}

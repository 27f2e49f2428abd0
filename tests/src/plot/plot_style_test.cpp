// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/plot_style.hpp"

#include <catch2/catch.hpp>

#include "src/plot/drawing.hpp"

using namespace triax::src;

TEST_CASE("a range that holds only noise is wide enough for ticks that differ") {
  RangeOf noise;
  noise.add(0.4362580);
  noise.add(0.4362590);
  const auto range = noise.with_margin(0.1, false);
  CHECK(range.lower < 0.4362580);
  CHECK(range.upper > 0.4362590);
  CHECK(range.size() > 1e-4 * 0.436);
  RangeOf plain;
  plain.add(1);
  plain.add(2);
  CHECK(plain.with_margin(0.1, false).lower == Approx(0.9));
}

TEST_CASE("an SVG has a white ground of its own") {
  const auto plot = make_plot(200, 100);
  const auto svg = to_svg(*plot);
  const auto ground = svg.find("<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>");
  REQUIRE(ground != std::string::npos);
  CHECK(ground < svg.find("<g"));
}

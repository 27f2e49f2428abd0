// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/curve_labels.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"

using namespace triax::src;

TEST_CASE("labels stand to the right of all curves in the order of their tops, apart") {
  auto plot = make_plot(500, 300);
  plot->xAxis->setRange(0, 1.5);
  plot->yAxis->setRange(0, 10);
  std::vector<LabelledCurve> curves;
  for (int i = 0; i < 5; ++i) {
    const double top = 5 + 0.1 * i;
    curves.push_back(
        {{{0, 0}, {0.5, top}, {1, 0}}, {0.5, top}, "curve " + std::to_string(i), kBlue});
  }
  label_beside(*plot->axisRect(), curves);
  CHECK(test::words_are_readable(*plot));
  const auto words = test::words_of(*plot);
  REQUIRE(words.size() == 5);
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {  // written from above
    CHECK(words[i]->text() == QString("curve %1").arg(4 - i));
    CHECK(test::place_of(*words[i]).bottom() <= test::place_of(*words[i + 1]).top());
    CHECK(test::place_of(*words[i]).left() > plot->xAxis->coordToPixel(0.5));
  }
}

TEST_CASE("without curves nothing is written") {
  auto plot = make_plot(500, 300);
  label_beside(*plot->axisRect(), {});
  CHECK(test::words_of(*plot).empty());
}

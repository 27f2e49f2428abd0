// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sweep/spread.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::study;

TEST_CASE("a spread is mean, extremes and the standard deviation of a sample") {
  const auto spread = spread_of({0.5, 0.7, 0.6, 0.6});
  REQUIRE(spread);
  CHECK(spread->mean == Approx(0.6));
  CHECK(spread->smallest == 0.5);
  CHECK(spread->largest == 0.7);
  CHECK(*spread->standard_deviation == Approx(std::sqrt(0.02 / 3)));
}

TEST_CASE("one value has no standard deviation; none has no spread") {
  CHECK(spread_of({3})->mean == 3);
  CHECK_FALSE(spread_of({3})->standard_deviation);
  CHECK_FALSE(spread_of({}));
}

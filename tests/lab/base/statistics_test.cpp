// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/statistics.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;

TEST_CASE("median and standard deviation of a few values") {
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 3);
  CHECK(std::isnan(median({})));
  CHECK(standard_deviation({2, 4, 4, 4, 5, 5, 7, 9}) == Approx(std::sqrt(32.0 / 7)));
  CHECK(standard_deviation({5, 5, 5}) == 0);
  CHECK(std::isnan(standard_deviation({5})));
}

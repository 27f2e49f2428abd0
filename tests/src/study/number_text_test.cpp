// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/number_text.hpp"

#include <catch2/catch.hpp>
#include <limits>

using triax::study::number_text;

TEST_CASE("a number as text: so many decimals, a dash for what is unknown, no minus on a zero") {
  CHECK(number_text(1.2345, 2) == "1.23");
  CHECK(number_text(-1.2, 1) == "-1.2");
  CHECK(number_text(-0.001, 2) == "0.00");
  CHECK(number_text(std::nullopt, 2) == "–");
  CHECK(number_text(std::numeric_limits<double>::infinity(), 2) == "–");
}

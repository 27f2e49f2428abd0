// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/toml_number.hpp"

#include <catch2/catch.hpp>
#include <limits>

using triax::lab::toml_number;

TEST_CASE("a number in TOML is a float in the fewest digits") {
  CHECK(toml_number(3) == "3.0");
  CHECK(toml_number(-0.1) == "-0.1");
  CHECK(toml_number(1e22) == "1e+22");
  CHECK(toml_number(0) == "0.0");
  CHECK(toml_number(std::numeric_limits<double>::infinity()) == "inf");
  CHECK(toml_number(std::numeric_limits<double>::quiet_NaN()) == "nan");
}

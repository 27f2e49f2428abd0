// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/no_value.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace triax::lab;

TEST_CASE("is_no_value_code: codes of loggers, and no other number", "[records]") {
  for (const double code :
       {-9999.0, -999.0,   -999.25,  -999.9,  -99999.0,     9999.0,
        99999.0, 999999.0, 6999.0,   -6999.0, 7999.0,       -7999.0,
        -8888.0, -7777.0,  -32768.0, 32767.0, 65535.0,      -2147483648.0,
        1e30,    -1e30,    9.9e37,   9.91e37, 3.4028235e38, 1.7976931348623157e308}) {
    INFO(code);
    CHECK(may_be_no_value(code));
    CHECK(is_no_value_code(code));
  }
  for (const double value : {0.0, -99.0, 999.0, 999.9, 1000.0, 9990.0, 9998.0, 9999.5, 10000.0,
                             -1000.0, -999.5, 32768.0, 1e6, 2e9, 1e12}) {
    INFO(value);
    CHECK_FALSE(is_no_value_code(value));
  }
}

TEST_CASE("means_no_value: a channel that passes through a code is read", "[records]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(means_no_value(9999, none));
  CHECK(means_no_value(9999, 400));
  CHECK(means_no_value(-9999, 9999));
  CHECK_FALSE(means_no_value(9999, 9980));
  CHECK_FALSE(means_no_value(-9999, -9700));
  CHECK_FALSE(means_no_value(9998, 400));
}

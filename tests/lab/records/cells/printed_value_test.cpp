// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/printed_value.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("half_unit_of: half a unit of the last printed digit") {
  CHECK(half_unit_of("1.234") == Approx(0.0005));
  CHECK(half_unit_of("-0,5") == Approx(0.05));
  CHECK(half_unit_of("12") == 0.5);
  CHECK(half_unit_of("12.") == 0.5);
  CHECK(half_unit_of("1.2e3") == Approx(50));
  CHECK(half_unit_of("5.99E-02") == Approx(0.00005));
  CHECK(half_unit_of("0.12345678901234567890") == Approx(0.5e-20));
}

TEST_CASE("PrintedValue: errors propagate as sums of absolute values") {
  const PrintedValue a{3, 0.1}, b{-2, 0.2};
  CHECK((a + b).error == Approx(0.3));
  CHECK((a - b).value == 5);
  CHECK((a - b).error == Approx(0.3));
  CHECK((-2 * a).error == Approx(0.2));
  CHECK((a * b).error == Approx(3 * 0.2 + 2 * 0.1 + 0.1 * 0.2));
}

TEST_CASE("PrintedValue: contradicts only beyond both errors") {
  CHECK(PrintedValue{1.0, 0.05}.contradicts({1.2, 0.05}, 1));
  CHECK_FALSE(PrintedValue{1.0, 0.05}.contradicts({1.1, 0.05}, 1));
  CHECK_FALSE(PrintedValue{100.0001, 0}.contradicts({100, 0}, 500));  // single precision
  CHECK(PrintedValue{100.0003, 0}.contradicts({100, 0}, 500));
  CHECK_FALSE(PrintedValue{}.contradicts({1, 0}, 1));
}

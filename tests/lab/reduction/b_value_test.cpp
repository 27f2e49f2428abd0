// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/b_value.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;
using triax::lab::testing::reading;

TEST_CASE("B counts from the first reading of the latest check, and asks for 5 kPa") {
  BValue b;
  b.add(reading({1, 0, 0, 100, 50, 0}), true);
  b.add(reading({1, 0, 0, 104, 54, 0}), true);
  CHECK_FALSE(b.value());
  b.add(reading({1, 0, 0, 120, 68, 0}), true);
  CHECK(*b.value() == Approx(0.9));
  CHECK_FALSE(b.check().ok);
  CHECK(b.check().note.find("not saturated") != std::string::npos);
  b.add(reading({2, 0, 0, 300, 68, 0}), false);
  CHECK(*b.value() == Approx(0.9));
  b.add(reading({3, 0, 0, 200, 150, 0}), true);
  b.add(reading({3, 0, 0, 250, 198.5, 0}), true);
  CHECK(*b.value() == Approx(0.97));
  CHECK(b.check().ok);
}

TEST_CASE("a reading without one of the two pressures says nothing of B") {
  BValue b;
  Reading gap = reading({1, 0, 0, 100, 50, 0});
  gap[Quantity::pore_pressure] = kMissing;
  b.add(gap, true);
  b.add(reading({1, 0, 0, 150, 50, 0}), true);
  CHECK_FALSE(b.value());
}

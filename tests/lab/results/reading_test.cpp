// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/reading.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("a new reading holds nothing; what is set is had") {
  Reading reading;
  for (const QuantityInfo& row : quantities()) CHECK_FALSE(reading.has(row.quantity));
  CHECK(std::isnan(reading.time_s));
  reading[Quantity::void_ratio] = 0.8;
  CHECK(reading.has(Quantity::void_ratio));
  CHECK(reading[Quantity::void_ratio] == 0.8);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/quantity.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("the table of quantities is in the order of the enumeration and every unit exists") {
  REQUIRE(quantities().size() == kQuantityCount);
  for (std::size_t i = 0; i < kQuantityCount; ++i) {
    const QuantityInfo& row = quantities()[i];
    CHECK(index(row.quantity) == i);
    CHECK(find_quantity(row.name) == row.quantity);
    CHECK(triax::sim::find_unit(row.unit));
  }
  CHECK(heading(Quantity::cell_pressure) == "cell_pressure_kPa");
  CHECK(heading(Quantity::void_ratio) == "void_ratio");
  CHECK_FALSE(find_quantity("cell_pressure_kPa"));
  CHECK(is_raw(Quantity::cell_volume));
  CHECK_FALSE(is_raw(Quantity::axial_strain));
}

TEST_CASE("every raw channel says what its instrument is, and nothing that is reduced does") {
  REQUIRE(raw_channels().size() == kRawQuantityCount);
  for (const QuantityInfo& row : quantities()) {
    INFO(row.name);
    CHECK(row.raw.sensor.empty() == !is_raw(row.quantity));
    CHECK((row.raw.spoken_unit.empty() || triax::sim::find_unit(row.raw.spoken_unit)->dimension ==
                                              triax::sim::find_unit(row.unit)->dimension));
    // A counter that may be set to zero needs a limit beyond which that is seen.
    CHECK((row.raw.zeroed == RawChannel::Zeroed::never || row.raw.drift_si > 0));
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/end_condition.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <string_view>

#include "sim/mechanics/units.hpp"

using namespace triax::lab;

TEST_CASE("an end is met at its bound") {
  EndCondition above;
  above.above = 5;
  CHECK(above.met(5));
  CHECK_FALSE(above.met(4.9));
  EndCondition below;
  below.below = -1;
  CHECK(below.met(-1));
  CHECK_FALSE(below.met(0));
}

TEST_CASE("keys are unique, their unit is in their name and has their scale") {
  std::set<std::string_view> seen;
  std::set<EndQuantity> quantities;
  for (const EndQuantityKey& key : end_quantity_keys()) {
    CHECK(seen.insert(key.key).second);
    quantities.insert(key.quantity);
    CHECK(key.lowest < key.highest);
    const std::string_view per_min = "_per_min";
    if (key.key.ends_with(per_min)) {
      const std::string_view of = key.key.substr(0, key.key.size() - per_min.size());
      const auto unit = triax::sim::find_unit(of.substr(of.rfind('_') + 1));
      REQUIRE(unit);
      CHECK(key.scale == Approx(unit->scale / 60));
      continue;
    }
    const bool number = key.quantity == EndQuantity::stress_ratio ||
                        key.quantity == EndQuantity::void_ratio ||
                        key.quantity == EndQuantity::b_value;
    if (number) continue;
    const auto unit = triax::sim::find_unit(key.key.substr(key.key.rfind('_') + 1));
    REQUIRE(unit);
    CHECK(unit->scale == key.scale);
  }
  CHECK(quantities.size() == kEndQuantityCount);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/law/mark.hpp"

#include <catch2/catch.hpp>
#include <optional>

using triax::sim::Mark;

TEST_CASE("a copy has the mark of its original, nothing else has, not even in its place") {
  std::optional<Mark> place{std::in_place};
  const Mark first = *place;
  CHECK(first == *place);
  place.emplace();
  CHECK(first != *place);
  CHECK(Mark() != Mark());
}

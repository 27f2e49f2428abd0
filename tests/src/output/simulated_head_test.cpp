// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/simulated_head.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("a fact is a line, an empty one nothing, a broken one still a line") {
  CHECK(src::fact("range", "0 to 1") == "  range       0 to 1\n");
  CHECK(src::fact("range", "").empty());
  CHECK(src::fact("range", "a\nb") == "  range       a b\n");
}

TEST_CASE("the head says that it is simulated, and with what") {
  const auto set = lab::find_material("inl2/S28-general");
  const std::string head = src::simulated_head("Cones", set);
  CHECK(head.find("Cones, inl2/S28-general (simulated)\n===") == 0);
  for (const auto& part : {set.law->title, set.source, set.range, set.material.based_on})
    CHECK(head.find(part) != std::string::npos);
}

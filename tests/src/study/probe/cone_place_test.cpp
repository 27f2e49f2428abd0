// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/cone_place.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("where an angle lies among cones") {
  CHECK_FALSE(study::place_among({}, 1.0));
  const std::vector<sim::Cone> cones = {{1.0, 2.0, {}}, {6.0, 6.6, {}}};
  const auto check = [&](double angle, bool inside, std::size_t cone, double edge) {
    INFO(angle);
    const auto place = study::place_among(cones, angle);
    REQUIRE(place);
    CHECK(place->inside == inside);
    CHECK(place->cone == cone);
    CHECK(place->to_edge == Approx(edge));
  };
  check(1.1, true, 0, 0.1);
  check(1.8, true, 0, 0.2);
  check(2.5, false, 0, 0.5);
  check(5.9, false, 1, 0.1);
  check(6.1, true, 1, 0.1);
  check(0.1, true, 1, 6.6 - 2 * std::numbers::pi - 0.1);  // beyond a turn
  check(0.5, false, 1, 0.5 - (6.6 - 2 * std::numbers::pi));
}

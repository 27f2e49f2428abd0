// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_words.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("cones in words") {
  CHECK(src::cones_in_words(std::vector<sim::Cone>{}) == "none");
  const sim::Cone cone{sim::radians(10), sim::radians(20.126), {}};
  CHECK(src::cones_in_words(std::vector{cone, cone}) == "10.00–20.13, 10.00–20.13");
}

TEST_CASE("without a cone the words say how many directions were answered") {
  sim::Circle circle;
  circle.least.answered = true;
  CHECK(src::cones_in_words(circle, 36) == "none");
  circle.unanswered = 6;
  CHECK(src::cones_in_words(circle, 36) == "none found in the 30 with a result");
  circle.unanswered = 36;
  circle.least.answered = false;
  CHECK(src::cones_in_words(circle, 36) == "unknown");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/first_negative.hpp"

#include <catch2/catch.hpp>

using triax::sim::first_negative;

TEST_CASE("a smooth zero is found in few evaluations, whichever way the bracket points") {
  int evaluations = 0;
  const auto value = [&](double x) {
    ++evaluations;
    return std::optional(2 - x * x);
  };
  const auto up = first_negative(0, 2, 3, -7, 1e-12, value);
  REQUIRE(up);
  CHECK(*up == Approx(std::sqrt(2.0)).epsilon(1e-12));
  CHECK(evaluations < 16);
  const auto down = first_negative(0, 2, -3, -7, 1e-12, value);
  REQUIRE(down);
  CHECK(*down == Approx(-std::sqrt(2.0)).epsilon(1e-12));
}

TEST_CASE("a jump is found too, and a bracket that begins at the zero") {
  const auto step = [](double x) { return std::optional(x < 0.3 ? 1.0 : -1e-9); };
  CHECK(*first_negative(0, 1, 1, -1e-9, 1e-10, step) == Approx(0.3).margin(1e-10));
  const auto line = [](double x) { return std::optional(-x); };
  CHECK(*first_negative(0, 0, 1, -1, 1e-12, line) == Approx(0).margin(1e-12));
}

TEST_CASE("where the value is unknown on the way nothing is found") {
  const auto gap = [](double) { return std::optional<double>(); };
  CHECK_FALSE(first_negative(0, 1, 1, -1, 1e-12, gap));
}

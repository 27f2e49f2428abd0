// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/straight_line.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using triax::lab::StraightLine;

TEST_CASE("a line meets zero where it does, with the closed form's error") {
  // y = 3 − x/2 at x = 0, 1, 2, 3 with σ = 0.1: x̄ = 1.5, Sxx = 5, slope −1/2, zero at 6;
  // var x₀ = σ²/b² (1/n + (x₀ − x̄)²/Sxx) = 0.04 (0.25 + 20.25/5) = 0.172.
  StraightLine line;
  for (int x = 0; x < 4; ++x) line.add(x, 3 - 0.5 * x, 0.1);
  const auto zero = line.zero();
  REQUIRE(zero);
  CHECK(zero->x == Approx(6).epsilon(1e-12));
  CHECK(zero->error == Approx(std::sqrt(0.172)).epsilon(1e-12));
  CHECK(line.independent() == 4);
}

TEST_CASE("scatter beyond the errors given widens the error of the zero") {
  // Residuals ±1 ±1 about the same line with σ = 0.1: χ² = 400 over 2 degrees of freedom.
  StraightLine line;
  const double off[] = {1, -1, -1, 1};
  for (int x = 0; x < 4; ++x) line.add(x, 3 - 0.5 * x + off[x], 0.1);
  REQUIRE(line.zero());
  CHECK(line.zero()->x == Approx(6));
  CHECK(line.zero()->error == Approx(std::sqrt(0.172 * 200)));
}

TEST_CASE("a point of half a share counts half, one of twice the error a quarter") {
  StraightLine halves, quarters;
  for (int x = 0; x < 6; ++x) {
    const double y = 2 - 0.3 * x + 0.05 * (x % 2);
    halves.add(x, y, 0.1, x < 3 ? 1 : 0.25);
    quarters.add(x, y, x < 3 ? 0.1 : 0.2);
  }
  CHECK(halves.zero()->x == Approx(quarters.zero()->x).epsilon(1e-12));
}

TEST_CASE("a line that does not fall meets no zero ahead, nor does one through two points") {
  StraightLine rising, level, two;
  for (int x = 0; x < 5; ++x) {
    rising.add(x, 1.0 + x, 0.1);
    level.add(x, 1.0, 0.1);
  }
  two.add(0, 2, 0.1);
  two.add(1, 1, 0.1);
  CHECK_FALSE(rising.zero());
  CHECK_FALSE(level.zero());
  CHECK_FALSE(two.zero());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/change_point.hpp"

#include <catch2/catch.hpp>
#include <random>

using triax::lab::ChangePoint;

TEST_CASE("noise about a positive mean gives no change in a hundred thousand values") {
  std::mt19937_64 rng(4);
  std::normal_distribution<double> noise(0, 0.05);
  ChangePoint change;
  for (int i = 0; i < 100000; ++i) {
    change.add(0.02 + noise(rng), 0.05, 1);
    REQUIRE_FALSE(change.found());
  }
}

TEST_CASE("a fall to negative is found, and the sum last stood at zero near the change") {
  std::mt19937_64 rng(5);
  std::normal_distribution<double> noise(0, 0.05);
  ChangePoint change;
  int last_zero = -1, found = -1;
  for (int i = 0; i < 1000 && found < 0; ++i) {
    if (change.add((i < 500 ? 0.1 : -0.1) + noise(rng), 0.05, 1)) last_zero = i;
    if (change.found()) found = i;
  }
  CHECK(std::abs(last_zero - 499) <= 3);
  CHECK(found > 499);
  CHECK(found < 520);
}

TEST_CASE("values too uncertain to tell are passed over, and overlap does not count twice") {
  ChangePoint change;
  for (int i = 0; i < 100; ++i) change.add(-1, 2, 1);
  CHECK_FALSE(change.found());
  for (int i = 0; i < 6; ++i) change.add(-0.9, 0.05, 1.0 / 7);
  CHECK_FALSE(change.found());  // six sevenths of one window
  change.add(-0.9, 0.05, 1.0 / 7);
  change.add(-0.9, 0.05, 1.0 / 7);
  CHECK(change.found());
}

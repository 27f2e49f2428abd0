// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/noise.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using triax::lab::standard_normal;

TEST_CASE(
    "noise has mean 0, rms 1, thin tails, and no correlation between neighbours or channels") {
  constexpr int kCount = 200000;
  double sum = 0, squares = 0, fourth = 0, neighbour = 0, channel = 0;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const double x = standard_normal(7, 2, i);
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
    neighbour += x * standard_normal(7, 2, i + 1);
    channel += x * standard_normal(7, 3, i);
  }
  CHECK(sum / kCount == Approx(0).margin(0.01));
  CHECK(squares / kCount == Approx(1).margin(0.015));
  CHECK(fourth / kCount == Approx(3).margin(0.1));
  CHECK(neighbour / kCount == Approx(0).margin(0.01));
  CHECK(channel / kCount == Approx(0).margin(0.01));
}

TEST_CASE("noise depends on nothing but its arguments") {
  CHECK(standard_normal(1, 2, 3) == standard_normal(1, 2, 3));
  CHECK(standard_normal(1, 2, 3) != standard_normal(2, 2, 3));
  CHECK(standard_normal(0, 0, 0) != standard_normal(0, 0, 1));
}

TEST_CASE("uniform numbers fill 0 to 1 evenly and are pure functions too") {
  constexpr int kCount = 100000;
  std::array<int, 10> bins{};
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const double u = triax::lab::standard_uniform(7, 2, i);
    REQUIRE((u > 0 && u < 1));
    ++bins[static_cast<std::size_t>(u * 10)];
  }
  for (const int count : bins) CHECK(count == Approx(kCount / 10).epsilon(0.04));
  CHECK(triax::lab::standard_uniform(7, 2, 5) == triax::lab::standard_uniform(7, 2, 5));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/largest_strength.hpp"

#include <catch2/catch.hpp>
#include <initializer_list>

using namespace triax::lab;

namespace {

/// Number of the reading (from 0) at which these q, in kPa, are largest; −1: none.
std::int64_t largest_of(std::initializer_list<double> path_kPa) {
  LargestStrength largest;
  std::int64_t reading = 0;
  for (const double q_kPa : path_kPa) {
    State state;
    state.reading = reading++;
    state.q = q_kPa * 1e3;
    largest.add(state);
  }
  return largest.state() ? largest.state()->reading : -1;
}

}  // namespace

TEST_CASE("the largest |q| of a path, in compression and in extension, the first of equals") {
  CHECK(largest_of({}) == -1);
  CHECK(largest_of({7}) == 0);
  CHECK(largest_of({10, 20, 30, 40, 30, 20}) == 3);
  CHECK(largest_of({-10, -20, -30, -25}) == 2);
  CHECK(largest_of({10, 20, 20, 20}) == 1);
}

TEST_CASE("a reading at which q more than doubles is a spike unless the next one confirms it") {
  CHECK(largest_of({10, 20}) == 1);  // twice, and no more
  CHECK(largest_of({10, 20.001}) == 0);
  CHECK(largest_of({10, 50, 11, 12}) == 3);
  CHECK(largest_of({10, 50, 25, 12}) == 1);  // half of it is left
  CHECK(largest_of({10, 50, 24.9, 12}) == 2);
  CHECK(largest_of({10, 50, 60, 12}) == 2);
}

TEST_CASE("a change of sign waits likewise; what is confirmed counts by its size") {
  CHECK(largest_of({10, -30}) == 0);
  CHECK(largest_of({10, -30, 12, 13}) == 3);
  CHECK(largest_of({10, -30, -40, -20}) == 2);
  CHECK(largest_of({10, -30, -16, 2}) == 1);
}

TEST_CASE("a state without q is passed over, at the start and beside a spike") {
  constexpr double kNone = kMissing;
  CHECK(largest_of({kNone, kNone}) == -1);
  CHECK(largest_of({kNone, 10, 15}) == 2);
  CHECK(largest_of({10, kNone, 15}) == 2);
  CHECK(largest_of({10, 50, kNone, 11}) == 3);
  CHECK(largest_of({10, 50, kNone, 45}) == 1);
}

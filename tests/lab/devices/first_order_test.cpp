// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/first_order.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using triax::lab::first_order;

TEST_CASE("a first-order lag answers a step with 1 - exp(-t/tau)") {
  CHECK(first_order(0, 1, 1, 3, 2) == Approx(1 - std::exp(-1.5)).epsilon(1e-15));
  CHECK(first_order(5, 1, 1, 3, 2) == Approx(1 + 4 * std::exp(-1.5)).epsilon(1e-15));
}

TEST_CASE("a first-order lag stays tau times the rate behind a long ramp") {
  CHECK(first_order(0, 0, 1000, 1000, 2) == Approx(1000 - 2).epsilon(1e-14));
}

TEST_CASE("the lag of a ramp does not depend on how it is cut into steps") {
  double cut = 3;
  for (int i = 0; i < 1000; ++i) cut = first_order(cut, 0.01 * i, 0.01 * (i + 1), 0.02, 7);
  CHECK(cut == Approx(first_order(3, 0, 10, 20, 7)).epsilon(1e-13));
}

TEST_CASE("without a time constant or at rest the lag gives its drive to the bit") {
  CHECK(first_order(17, 1, 0.1, 3, 0) == 0.1);
  CHECK(first_order(0.3, 0.3, 0.3, 1, 2) == 0.3);
  CHECK(first_order(0.3, 5, 6, 0, 2) == 0.3);
}

TEST_CASE("a lag that is long beside the step loses no digits") {
  // y = x_end dt/(2 tau) - ..., of a ramp from 0
  CHECK(first_order(0, 0, 1, 1, 1e8) == Approx(0.5e-8).epsilon(1e-6));
}

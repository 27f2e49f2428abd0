// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scans/last_bits.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::db;

TEST_CASE("neighbouring doubles are one unit in the last place apart, across both zeros") {
  for (const double x : {1.0, -1.0, 0.1, 1e300, 5e-324})
    CHECK(ulps_between(x, std::nextafter(x, 1e308)) == 1);
  CHECK(ulps_between(-0.0, 0.0) == 1);
  CHECK(ulps_between(0.0, -0.0) == -1);
  CHECK(std::signbit(moved_by_ulps(0.0, -1)));
  CHECK(moved_by_ulps(0.0, -2) == -5e-324);
  CHECK(moved_by_ulps(1.0, 3) == 1 + 3 * 0x1p-52);
}

TEST_CASE("distant doubles never look near") {
  const double largest = 1.7976931348623157e308;
  for (const double from : {largest, -largest, 1.0, -1.0})
    CHECK(std::abs(ulps_between(from, -from)) > 1000);
}

TEST_CASE("packed fields keep their numbers apart") {
  const BitField low{3, 3}, high{57, 6};
  const std::int64_t all = low.packed(-4) | high.packed(-7);
  CHECK(low.get(all) == -4);
  CHECK(high.get(all) == -7);
  CHECK(BitField{6, 6}.get(all) == 0);
  CHECK((low.holds(-4) && low.holds(3)));
  CHECK_FALSE((low.holds(-5) || low.holds(4)));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/collapse_increment.hpp"

#include <catch2/catch.hpp>

using namespace triax::study;

namespace {

CollapseIncrement along(double dp, double dq) {
  CollapseIncrement increment;
  increment.dp = dp;
  increment.dq = dq;
  return increment;
}

}  // namespace

TEST_CASE("directions are told from isotropic unloading, to both sides of it") {
  CHECK(along(-3, 0).degrees_from_unloading() == Approx(0).margin(1e-12));
  CHECK(along(-1, -1).degrees_from_unloading() == Approx(45));
  CHECK(along(-1, 1).degrees_from_unloading() == Approx(-45));
  CHECK(along(0, 2).degrees_from_unloading() == Approx(-90));
}

TEST_CASE("the range of directions is that of all increments") {
  const auto [lowest, highest] = direction_range({along(-1, 0), along(-1, 1), along(0, -1)});
  CHECK(lowest == Approx(-45));
  CHECK(highest == Approx(90));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/calibrate/held_share.hpp"

#include <catch2/catch.hpp>

using triax::bench::HeldShare;

// Two sets of four, of which 2 and 4 are held: p = 6/8, s² = 2/1 ((2 − 3)² + (4 − 3)²)/8² = 1/16.
TEST_CASE("The standard error of a share goes by sets") {
  HeldShare share;
  share.add(2, 4);
  share.add(4, 4);
  CHECK(share.held() == 6);
  CHECK(share.share() == Approx(0.75));
  CHECK(share.standard_error() == Approx(0.25));
  CHECK(share.plausible());
}

// A hundred sets alike: √(0.95 · 0.05/2000) = 0.0048734; three of them are 0.0146 below 93 %.
TEST_CASE("What lies out by more than three standard errors is not by chance") {
  const auto of = [](int held) {
    HeldShare share;
    for (int i = 0; i < 100; ++i) share.add(held, 20);
    return share;
  };
  CHECK(of(19).standard_error() == Approx(0.0048734).epsilon(1e-4));
  CHECK(of(19).plausible());
  CHECK_FALSE(of(18).plausible());
  CHECK_FALSE(of(20).plausible());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/block_pyramid.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

PathSample sample(double q) {
  PathSample s;
  s.signal[PathSample::q] = q;
  return s;
}

}  // namespace

TEST_CASE("blocks of level L are the means of 2^L successive samples") {
  BlockPyramid pyramid;
  for (int i = 0; i < 64; ++i) pyramid.add(sample(i));
  REQUIRE(pyramid.full(3));
  CHECK_FALSE(pyramid.full(4));  // 64 samples are four blocks of 16
  // Level 3 holds the last seven of eight blocks: samples 8..15 are the oldest.
  CHECK(pyramid.block(3, 0).signal[PathSample::q] == Approx(11.5));
  CHECK(pyramid.block(3, 6).signal[PathSample::q] == Approx(59.5));
  CHECK(pyramid.block(0, 6).signal[PathSample::q] == 63);
  CHECK(pyramid.samples() == 64);
}

TEST_CASE("a level closes every 2^L samples") {
  BlockPyramid pyramid;
  for (int i = 1; i <= 32; ++i) {
    pyramid.add(sample(0));
    int levels = 1;
    for (int n = i; n % 2 == 0; n /= 2) ++levels;
    CHECK(pyramid.closed_levels() == levels);
  }
}

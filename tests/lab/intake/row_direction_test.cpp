// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/row_direction.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

RowDirection of(double from, double step, int rows) {
  RowDirection direction;
  for (int i = 0; i < rows; ++i) direction.add(from + step * i);
  return direction;
}

}  // namespace

TEST_CASE("RowDirection: a time that decreases runs back") {
  CHECK(of(100, -1, 20).runs_back());
  CHECK_FALSE(of(100, 1, 20).runs_back());
  CHECK_FALSE(of(100, -1, 4).runs_back());
  CHECK_FALSE(RowDirection().runs_back());
}

TEST_CASE("RowDirection: a strain of either sign that ends near zero runs to zero") {
  CHECK(of(0.2, -0.01, 21).runs_to_zero());
  CHECK(of(-0.2, 0.01, 21).runs_to_zero());
  CHECK_FALSE(of(0.2, -0.01, 11).runs_to_zero());
  CHECK_FALSE(of(0, -0.01, 21).runs_to_zero());
}

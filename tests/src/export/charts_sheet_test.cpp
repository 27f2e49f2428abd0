// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/charts_sheet.hpp"

#include <catch2/catch.hpp>

using namespace triax::src;

TEST_CASE("the axis of a pore pressure begins and ends where its values do") {
  using Ends = std::pair<double, double>;
  CHECK(axis_ends(500.7, 603.1) == Ends(500, 650));  // steps of 50, not from zero
  CHECK(axis_ends(437.3, 682.0) == Ends(400, 700));
  CHECK(axis_ends(300, 300) == Ends(300, 300.2));
  CHECK(axis_ends(-33, 270) == Ends(-100, 300));
}

TEST_CASE("a pore pressure that is not known is none") {
  ShearRows rows;
  rows.add_pore(std::nan(""));
  CHECK_FALSE(rows.pore_kPa);
  rows.add_pore(5);
  rows.add_pore(3);
  CHECK(rows.pore_kPa == std::pair(3.0, 5.0));
}

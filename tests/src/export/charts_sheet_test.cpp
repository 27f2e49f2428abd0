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

TEST_CASE("ChartLines: a gap ends a line, an unread step is a dotted one") {
  using triax::study::Join;
  ChartLines lines;
  for (std::size_t row = 2; row < 5; ++row) lines.add(row, Join::solid);
  lines.add(9, Join::none);
  lines.add(10, Join::solid);
  lines.add(11, Join::dotted);
  lines.add(12, Join::solid);
  const auto& ranges = lines.ranges();
  REQUIRE(ranges.size() == 4);
  const auto is = [&](std::size_t i, std::size_t first, std::size_t last, bool dotted) {
    return ranges[i].first == first && ranges[i].last == last && ranges[i].dotted == dotted;
  };
  CHECK(is(0, 2, 4, false));
  CHECK(is(1, 9, 10, false));
  CHECK(is(2, 10, 11, true));
  CHECK(is(3, 11, 12, false));
}

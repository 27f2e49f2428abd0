// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/cell_extents.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "lab/records/cells/cells.hpp"

using namespace triax::lab;

namespace {

using Cells = std::vector<std::string_view>;

Cells cells_of_line(std::string_view line) {
  Cells cells;
  split_cells(line, Separator::wide_blanks, cells);
  return cells;
}

CellExtents extents_of(std::initializer_list<std::string_view> lines) {
  CellExtents out(3);
  for (const std::string_view line : lines) out.add(line, cells_of_line(line));
  return out;
}

}  // namespace

TEST_CASE("CellExtents: a blank cell leaves the others in their columns") {
  const CellExtents extents =
      extents_of({"Phase       Kraft   Druck", "Sättigung    10.5   100.0"});
  const std::string line = "Sättigung           102.5";
  Cells cells = cells_of_line(line);
  REQUIRE(cells.size() == 2);
  REQUIRE(extents.place(line, cells));
  CHECK(cells == Cells{"Sättigung", "", "102.5"});
}

TEST_CASE("CellExtents: characters count, not bytes") {
  const CellExtents extents = extents_of({"äöüäöü  1.0  2.0", "a       1.0  2.0"});
  const std::string line = "äöü          3.0";
  Cells cells = cells_of_line(line);
  REQUIRE(extents.place(line, cells));
  CHECK(cells == Cells{"äöü", "", "3.0"});
}

TEST_CASE("CellExtents: a cell between two columns is not placed") {
  const CellExtents extents = extents_of({"a   b   c", "1   2   3"});
  for (const std::string line : {"1  2", "  1", "1   2345678"}) {
    Cells cells = cells_of_line(line);
    const Cells before = cells;
    INFO(line);
    CHECK_FALSE(extents.place(line, cells));
    CHECK(cells == before);
  }
}

TEST_CASE("CellExtents: columns that overlap are no columns") {
  const CellExtents extents = extents_of({"1   22   3", "1          2   3"});
  const std::string line = "1   3";
  Cells cells = cells_of_line(line);
  CHECK_FALSE(extents.place(line, cells));
  CHECK_FALSE(CellExtents().place(line, cells));
}

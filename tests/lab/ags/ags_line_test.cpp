// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_line.hpp"
#include "lab/intake/text/file_kind.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
using Cells = std::vector<std::string>;

namespace {
Cells cells_of(const std::string& line) {
  Cells cells;
  REQUIRE(split_ags_line(line, cells).empty());
  return cells;
}
std::string wrong_with(const std::string& line) {
  Cells cells;
  return split_ags_line(line, cells);
}
}  // namespace

TEST_CASE("cells of AGS4: commas and doubled quotes inside quotes, blank cells, none without") {
  CHECK(cells_of(R"("DATA","a, b","1 1/2"" core","","""")") ==
        Cells{"DATA", "a, b", "1 1/2\" core", "", "\""});
  CHECK(cells_of(R"("DATA" , " 1 ",)") == Cells{"DATA", " 1 ", ""});
  CHECK(cells_of("DATA, 1.5 ,,5\" pipe") == Cells{"DATA", "1.5", "", "5\" pipe"});
  CHECK(cells_of(R"("a""")") == Cells{"a\""});
  CHECK(cells_of("") == Cells{""});
}

TEST_CASE("a quote that is not closed or not doubled is told with its cell") {
  CHECK(wrong_with(R"("DATA","soft)") ==
        "the quote of cell 2 is not closed; an AGS4 cell cannot contain a line break");
  CHECK(wrong_with(R"("DATA","5" pipe","x")") ==
        "text after the closing quote of cell 2, '5'; write a quote inside a cell twice");
  CHECK(wrong_with("\"").find("cell 1 is not closed") != std::string::npos);
  CHECK(wrong_with(R"("a"")").find("cell 1 is not closed") != std::string::npos);
}

TEST_CASE("begins_ags3: groups of AGS 3, with and without quotes") {
  for (const char* const line : {"\"**PROJ\"", "**PROJ", "**HOLE,x", " \"**GEOL\",\"\""})
    CHECK(begins_ags3(line));
  for (const char* const line : {"\"GROUP\",\"PROJ\"", "** logger **", "**", "**Note", ""})
    CHECK_FALSE(begins_ags3(line));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_reader.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {

const std::string kHead =
    "\"GROUP\",\"TRIT\"\r\n\"HEADING\",\"LOCA_ID\",\"TRIT_CELL\"\r\n\"UNIT\",\"\",\"kPa\"\r\n"
    "\"TYPE\",\"ID\",\"0DP\"\r\n";

/// What reading to the end says is wrong; empty for nothing.
std::string fault_of(const std::string& text) {
  const auto source = open_memory("x.ags", text);
  try {
    AgsReader reader(*source);
    while (reader.next()) {
    }
  } catch (const BadInput& error) {
    return error.what();
  }
  return {};
}

bool is_ags(const std::string& name, const std::string& text) {
  return looks_like_ags(*open_memory(name, text));
}

}  // namespace

TEST_CASE("AGS4 is read group by group, row by row, cells by their headings") {
  const auto source = open_memory(
      "x.ags", kHead + "\"DATA\",\"BH1\",\"120\"\r\n\"DATA\",\" BH2 \",\"\"\r\n\r\n" +
                   "\"GROUP\",\"PROJ\"\r\n\"HEADING\",\"PROJ_ID\"\r\n\"DATA\",\"7\"\r\n");
  AgsReader reader(*source);
  REQUIRE(reader.next());
  CHECK(reader.group().name == "TRIT");
  CHECK(reader.group().headings[1].unit == "kPa");
  CHECK(reader.group().headings[1].type == "0DP");
  CHECK(reader.group().unit_line == 3);
  CHECK(reader.cell("TRIT_CELL") == "120");
  CHECK(reader.cell("TRIT_DEVF").empty());
  CHECK(reader.line() == 5);
  REQUIRE(reader.next());
  CHECK(reader.cell("LOCA_ID") == "BH2");
  CHECK(reader.cell("TRIT_CELL").empty());
  REQUIRE(reader.next());
  CHECK(reader.cell("PROJ_ID") == "7");
  CHECK(reader.group().unit_line == 0);
  CHECK_FALSE(reader.next());
  CHECK(reader.group_names() == std::vector<std::string>{"TRIT", "PROJ"});
  CHECK(reader.recoded_line() == 0);
}

TEST_CASE("byte-order mark, Windows-1252, the end mark of DOS and a spreadsheet's cells") {
  const auto source = open_memory("x.ags",
                                  "\xEF\xBB\xBFGROUP,TRIT,,\nHEADING,LOCA_ID,TRIT_REM,\nUNIT,,,\n"
                                  "DATA,B\xFC\x68l,\"5\xB0\",\n\x1A\"nothing behind\n");
  AgsReader reader(*source);
  REQUIRE(reader.next());
  CHECK(reader.cell("LOCA_ID") == "Bühl");
  CHECK(reader.cell("TRIT_REM") == "5°");
  CHECK(reader.recoded_line() == 4);
  CHECK_FALSE(reader.next());
  CHECK(fault_of(kHead + "\"DATA\",\"BH1\",\"120\"\x1A").empty());
}

TEST_CASE("what is broken in AGS4 is told with its line") {
  CHECK(fault_of(kHead + "\"DATA\",\"BH1\",\"12\r\n").find("x.ags:5: the quote of cell 3") == 0);
  CHECK(fault_of(kHead + "\"DATA\",\"BH1\"\r\n") ==
        "x.ags:5: the DATA row has 1 cells; group 'TRIT' has 2 headings");
  CHECK(fault_of(kHead + "\"DATA\",\"BH1\",\"1\",\"2\"\r\n").find("has 3 cells") !=
        std::string::npos);
  CHECK(fault_of("\"DATA\",\"BH1\"\n") == "x.ags:1: a DATA row before the first GROUP row");
  CHECK(fault_of("\"GROUP\",\"TRIT\"\n\"DATA\",\"BH1\"\n") ==
        "x.ags:2: a DATA row before the HEADING row of group 'TRIT'");
  CHECK(fault_of("\"GROUP\",\"TRIT\"\n\"UNIT\",\"\"\n").find("x.ags:2: a UNIT row before") == 0);
  CHECK(fault_of(kHead + "\"UNIT\",\"\",\"\"\n") == "x.ags:5: a second UNIT row in group 'TRIT'");
  CHECK(fault_of(kHead + "\"HEADING\",\"LOCA_ID\"\n").find("x.ags:5: a second HEADING row") == 0);
  CHECK(fault_of("\"GROUP\",\"A\"\n\"HEADING\",\"X\"\n\"DATA\",\"1\"\n\"UNIT\",\"\"\n") ==
        "x.ags:4: a UNIT row below the first DATA row of group 'A'");
  CHECK(fault_of("\"GROUP\",\"A\"\n\"HEADING\",\"X\",\"X\"\n") ==
        "x.ags:2: heading 'X' appears twice in group 'A'");
  CHECK(fault_of("\"GROUP\",\"A\"\n\"HEADING\",\"\",\"X\"\n").find("empty cell") !=
        std::string::npos);
  CHECK(fault_of("\"GROUP\"\n").find("x.ags:1: the GROUP row has 0 cells") == 0);
  CHECK(fault_of("\"GROUP\",\"A\",\"B\"\n").find("the GROUP row has 2 cells") != std::string::npos);
  CHECK(fault_of(kHead + "\"REMARK\",\"\"\n").find("x.ags:5: the line begins with 'REMARK'") == 0);
  CHECK(fault_of("\"**PROJ\"\n\"*PROJ_ID\"\n").find("x.ags:1: this is AGS 3") == 0);
  CHECK(fault_of(std::string("\"GROUP\",\"A\0\"\n", 13)).find("NUL") != std::string::npos);
}

TEST_CASE("AGS is recognised from its first line") {
  CHECK(is_ags("x.txt", "\xEF\xBB\xBF\r\n\"GROUP\",\"PROJ\"\n"));
  CHECK(is_ags("x.csv", "GROUP,PROJ\n"));
  CHECK(is_ags("x.csv", "\"**PROJ\"\n"));
  CHECK(is_ags("x.AGS", "\"HEADING\",\"LOCA_ID\"\n"));
  CHECK_FALSE(is_ags("x.csv", "\"HEADING\",\"LOCA_ID\"\n"));
  CHECK_FALSE(is_ags("x.ags", "axial_strain,deviator_stress_kPa\n"));
  CHECK_FALSE(is_ags("x.ags", ""));
}

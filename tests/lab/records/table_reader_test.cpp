// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/table_reader.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/records/tables/table_recognition.hpp"

using namespace triax::lab;
using enum Quantity;

namespace {
struct Table {
  std::vector<Row> rows;
  std::vector<Warning> warnings;
  std::string trailer;
};
Table read_whole(const std::string& text, const std::optional<Dialect>& dialect = {}) {
  const auto source = open_memory("m.csv", text);
  Table table;
  Findings findings(table.warnings);
  const TableLayout layout = recognise_table(*source, dialect, findings);
  TableReader reader(*source, layout, findings);
  Row row;
  while (reader.next(row)) table.rows.push_back(row);
  table.trailer = reader.trailer();
  findings.finish();
  return table;
}
const std::string kHeadingsOfFour =
    "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa\n";
}  // namespace

TEST_CASE("rows come in SI with their line, the same by the fast and by the general way") {
  const auto fast = read_whole(kHeadingsOfFour + "0.0,0.1,0.2,800.5\n1.0,0.2,0.3,801.5\n");
  const auto quoted =
      read_whole(kHeadingsOfFour + "0.0,0.1,0.2,800.5\n\"1.0\", 0.2 ,3e-1,\"801.5\"\n");
  REQUIRE(fast.rows.size() == 2);
  REQUIRE(quoted.rows.size() == 2);
  CHECK(fast.rows[1].line == 3);
  CHECK(fast.rows[1].time_s == 1);
  CHECK(fast.rows[1].si[index(cell_pressure)] == 801.5e3);
  CHECK(std::isnan(fast.rows[1].si[index(pore_pressure)]));
  for (const Quantity q : {axial_displacement, axial_force, cell_pressure})
    CHECK(fast.rows[1].si[index(q)] == quoted.rows[1].si[index(q)]);
  CHECK(fast.warnings.empty());
}

TEST_CASE("missing cells are missing, not zero, and are counted") {
  const auto table =
      read_whole(kHeadingsOfFour + "0.0,0.1,0.2,800\n1,0.1,,800\n2,0.1,\"\",800\n3,0.1,0.5,800\n");
  REQUIRE(table.rows.size() == 4);
  CHECK(std::isnan(table.rows[1].si[index(axial_force)]));
  CHECK(std::isnan(table.rows[2].si[index(axial_force)]));
  CHECK(table.rows[3].si[index(axial_force)] == 500);
  REQUIRE(table.warnings.size() == 1);
  CHECK(table.warnings[0].line == 3);
  CHECK_THAT(table.warnings[0].text, Catch::Contains("1 more, the last in line 4"));
}

TEST_CASE("TableReader: a code for no value is a missing cell, in any unit", "[records]") {
  for (const char* code : {"-9999", "-999.25", "9999", "1e30", "9.9E+37", "6999.0", "-32768"}) {
    INFO(code);
    const auto table = read_whole(kHeadingsOfFour + "0,0.1,0.2,800\n1,0.1," + code + ",800\n2," +
                                  code + "," + code + ",800\n3,0.1,0.5," + code + "\n");
    REQUIRE(table.rows.size() == 4);
    CHECK(std::isnan(table.rows[1].si[index(axial_force)]));
    CHECK(std::isnan(table.rows[2].si[index(axial_force)]));
    CHECK(std::isnan(table.rows[2].si[index(axial_displacement)]));
    CHECK(std::isnan(table.rows[3].si[index(cell_pressure)]));
    CHECK(table.rows[3].si[index(axial_force)] == 500);
    REQUIRE(table.warnings.size() == 3);
    CHECK(table.warnings[0].line == 3);
    CHECK_THAT(table.warnings[0].text, Catch::Contains("'axial_force_kN'") &&
                                           Catch::Contains(std::string("'") + code + "'") &&
                                           Catch::Contains("1 more, the last in line 4"));
  }
  const auto moving = read_whole(
      "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,back_volume_mm3\n"
      "0,0.1,0.2,800,9000\n1,0.1,0.2,800,-9999\n2,0.1,0.2,800,9980\n3,0.1,0.2,800,9999\n");
  REQUIRE(moving.rows.size() == 4);
  CHECK(std::isnan(moving.rows[1].si[index(back_volume)]));
  CHECK(moving.rows[3].si[index(back_volume)] == Approx(9999e-9));
}

TEST_CASE("TableReader: a number with a remark is a missing cell of a foreign table") {
  const std::string headings = "q,delta_u,p_prime,epsilon_a\n0,0,100,0\n";
  for (const std::string cell : {"15 (hard to read)", "15?", "15 *", "-1.5 [bumped]"}) {
    INFO(cell);
    const auto table =
        read_whole(headings + "10," + cell + ",95,0.1\n20,6,90,0.2\n", find_dialect("cyclic"));
    REQUIRE(table.rows.size() == 3);
    CHECK(std::isnan(table.rows[1].si[index(excess_pore_pressure)]));
    REQUIRE(table.warnings.size() == 1);
    CHECK(table.warnings[0].text ==
          "column 'delta_u' has '" + cell + "', a number with a remark: read as missing");
  }
  for (const std::string cell : {"(hard to read)", "15 hard", "15 20", "abc?", "1.2.3?"})
    CHECK_THROWS_WITH(read_whole(headings + "10," + cell + ",95,0.1\n", find_dialect("cyclic")),
                      Catch::Contains("is not a number"));
  CHECK_THROWS_WITH(read_whole(kHeadingsOfFour + "0,0.1,0.2 (?),800\n"),
                    Catch::Contains("is not a number"));
}

TEST_CASE("TableReader: a row that begins with an error word is a row beside comments") {
  const auto table = read_whole(
      "# Sample 7\nepsilon_a,q,p_prime\n0,0,100\n0.1,10,102\n#DIV/0!,20,104\n# paused\n0.3,30,106\n"
      "0.4,35,108\n");
  REQUIRE(table.rows.size() == 5);
  CHECK(std::isnan(table.rows[2].si[index(axial_strain)]));
  CHECK(table.rows[2].si[index(deviator_stress)] == 20e3);
}

TEST_CASE("our own format has no word for a missing value") {
  for (const std::string word :
       {"NaN", "nan", "-nan", "NA", "-", "null", "#DIV/0!", "inf", "-inf"}) {
    INFO(word);
    CHECK_THROWS_WITH(read_whole(kHeadingsOfFour + "0,0.1,0.2,800\n1,0.1," + word + ",800\n"),
                      Catch::StartsWith("m.csv:3: column 'axial_force_kN' has '" + word + "'") &&
                          Catch::EndsWith("leave the cell empty if the reading is missing"));
  }
  CHECK_THROWS_AS(read_whole(kHeadingsOfFour + "NaN,0.1,0.2,800\n"), BadInput);
}

TEST_CASE("a foreign table's words for missing are missing, with a warning") {
  const std::string headings = "q,delta_u,p_prime,epsilon_a\n";
  const auto table =
      read_whole(headings + "0,0,100,0\n10,NaN,95,0.1\n20,#N/A,90,0.2\n30,inf,90,0.3\n");
  REQUIRE(table.rows.size() == 4);
  CHECK(std::isnan(table.rows[1].si[index(excess_pore_pressure)]));
  CHECK(table.rows[2].si[index(deviator_stress)] == 20e3);
  REQUIRE(table.warnings.size() == 1);
  CHECK(table.warnings[0].line == 3);
  auto strict = find_dialect("cyclic");
  strict.missing_words = false;
  CHECK_THROWS_WITH(read_whole(headings + "0,NaN,100,0\n", strict),
                    Catch::Contains("leave the cell empty"));
}

TEST_CASE("lines without values are left out, those inside the table are reported") {
  const auto table = read_whole(kHeadingsOfFour + "\n0,0.1,0.2,800\n\n1,0.1,0.2,800\n,,,\n\n\n");
  CHECK(table.rows.size() == 2);
  REQUIRE(table.warnings.size() == 2);
  CHECK(table.warnings[0].line == 4);
  CHECK(table.warnings[1].line == 6);
}

TEST_CASE("what is wrong in a row is named with line and column") {
  const std::string row = "0,0.1,0.2,800\n";
  const std::pair<std::string, std::string> wrong[] = {
      {"1,0.1,abc,800\n", "m.csv:3: column 'axial_force_kN' has 'abc', which is not a number"},
      {"1,0.1,0.2\n", "m.csv:3: 3 cells, but the headings in line 1 have 4"},
      {"1,0.1,0.2,800,900\n", "m.csv:3: 5 cells"},
      {"1,0.1,0.2", "m.csv:3: the file is truncated"},
      {"1,0.1,inf,800\n", "'inf', which is not a number; leave the cell empty"},
      {"1,0.1,1e400,800\n", "not a possible value of an instrument"},
      {"1;0.1;0.2;800\n", "m.csv:3: 1 cell, but the headings in line 1 have 4"}};
  for (const auto& [last, message] : wrong) {
    INFO(last);
    CHECK_THROWS_WITH(read_whole(kHeadingsOfFour + row + last), Catch::Contains(message));
  }
  CHECK(read_whole(kHeadingsOfFour + row + "1,0.1,0.2,800,,\n").rows.size() == 2);
}

TEST_CASE("a last line that may have been cut is reported") {
  const auto table = read_whole(kHeadingsOfFour + "0,0.1,0.2,800\n1,0.1,0.2,80");
  CHECK(table.rows.size() == 2);
  REQUIRE(table.warnings.size() == 1);
  CHECK(table.warnings[0].line == 3);
}

TEST_CASE("metadata below the rows is kept for its reader with its lines") {
  const auto table =
      read_whole(kHeadingsOfFour + "0,0.1,0.2,800\n# [truth]\n#   a = 1\n1,0.1,0.2,800\n# b = 2\n");
  CHECK(table.rows.size() == 2);
  CHECK(table.trailer == "[truth]\n  a = 1\n\nb = 2\n");
}

TEST_CASE("TableReader: headings that appear again are no row") {
  const auto table =
      read_whole(kHeadingsOfFour + "0,0.1,0.2,800\n" + kHeadingsOfFour + "1,0.2,0.3,800\n");
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[1].line == 4);
}

TEST_CASE("TableReader: a cell that is no proper number is an error with its line") {
  for (const std::string word : {"+-5", "--5", "1e-400", "0x10", "1.2.3"})
    CHECK_THROWS_WITH(read_whole(kHeadingsOfFour + "0,0.1,0.2,800\n1,0.1," + word + ",800\n"),
                      Catch::StartsWith("m.csv:3: column 'axial_force_kN' has '" + word + "'"));
}

TEST_CASE("TableReader: a reduced stress beyond any apparatus is an error") {
  const std::string headings = "axial_strain,deviator_stress_kPa,mean_effective_stress_kPa\n";
  CHECK_THROWS_WITH(read_whole(headings + "0,0,100\n0.1,2e6,100\n"),
                    Catch::StartsWith("m.csv:3: column 'deviator_stress_kPa' has '2e6', beyond"));
}

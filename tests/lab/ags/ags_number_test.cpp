// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_number.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {

struct Read {
  std::optional<double> si;
  std::vector<Warning> warnings;
};

Read read_cell(const std::string& unit, const std::string& cell, std::string_view usual) {
  const auto source =
      open_memory("x.ags", "\"GROUP\",\"TRIT\"\n\"HEADING\",\"TRIT_X\"\n\"UNIT\",\"" + unit +
                               "\"\n\"DATA\",\"" + cell + "\"\n");
  AgsReader reader(*source);
  REQUIRE(reader.next());
  Read read;
  Findings findings(read.warnings);
  read.si = AgsNumbers(reader, findings).si("TRIT_X", usual);
  return read;
}

}  // namespace

TEST_CASE("the UNIT row of AGS4 is honoured") {
  CHECK(*read_cell("kPa", "120", "kPa").si == 120e3);
  CHECK(*read_cell("MPa", "0.12", "kPa").si == Approx(120e3));
  CHECK(*read_cell("kN/m2", "120", "kPa").si == 120e3);
  CHECK(*read_cell("KPA", "+120", "kPa").si == 120e3);
  CHECK(*read_cell("psi", "10", "kPa").si == Approx(68947.57));
  CHECK(*read_cell("%", "11.3", "%").si == Approx(0.113));
  CHECK(*read_cell("-", "0.113", "%").si == Approx(0.113));
  CHECK(*read_cell("in", "2", "mm").si == Approx(0.0508));
  CHECK(*read_cell("kg/m3", "1650", "Mg/m3").si == Approx(1650));
  CHECK(*read_cell("", "0.97", "").si == 0.97);
  CHECK(read_cell("", "0.97", "").warnings.empty());
  CHECK_FALSE(read_cell("furlong", "", "kPa").si);  // nothing there, nothing wrong
}

TEST_CASE("what is assumed about a number, or left out, is a finding") {
  const Read unitless = read_cell("", "120", "kPa");
  CHECK(*unitless.si == 120e3);
  REQUIRE(unitless.warnings.size() == 1);
  CHECK(unitless.warnings[0].line == 4);
  CHECK(unitless.warnings[0].text ==
        "TRIT_X has no unit; read as kPa, the unit of the AGS4 dictionary");

  const Read weight = read_cell("kN/m3", "18.63", "Mg/m3");
  CHECK(*weight.si == Approx(1899.7).margin(0.1));
  CHECK(weight.warnings.size() == 1);

  for (const char* word : {"NA", ">20", "1,65", "nan", "inf", "1e999"}) {
    INFO(word);
    const Read none = read_cell("%", word, "%");
    CHECK_FALSE(none.si);
    REQUIRE(none.warnings.size() == 1);
    CHECK(none.warnings[0].text.find("which is not a number; ignored") != std::string::npos);
  }
  const Read dense = read_cell("Mg/m3", "19.2", "Mg/m3");
  CHECK_FALSE(dense.si);
  CHECK(dense.warnings.at(0).text.find("which is impossible for soil") != std::string::npos);
}

TEST_CASE("a unit that is unknown or of another kind is refused, at the UNIT row") {
  CHECK_THROWS_WITH(
      read_cell("furlong", "1", "kPa"),
      "x.ags:3: TRIT_X is in 'furlong', an unknown unit; the AGS4 dictionary has kPa");
  CHECK_THROWS_WITH(read_cell("mm", "1", "kPa"),
                    Catch::Contains("which does not fit this quantity"));
  CHECK_THROWS_AS(read_cell("kPa", "1", ""), BadInput);
}

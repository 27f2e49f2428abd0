// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/tables/table_recognition.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {
TableLayout layout_of(const std::string& text, const std::optional<Dialect>& forced = {},
                      std::vector<Warning>* warnings = nullptr) {
  const auto source = open_memory("m.csv", text);
  std::vector<Warning> ignored;
  Findings findings(warnings ? *warnings : ignored);
  return recognise_table(*source, forced, findings);
}
const std::string kHeadingsOfFive =
    "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,back_volume_mm3";
}  // namespace

TEST_CASE("our own table is known by its headings, and uses commas as separator") {
  const auto layout = layout_of(kHeadingsOfFive + "\n0,1\n");
  CHECK(layout.dialect.name == "triax");
  CHECK(layout.separator == Separator::comma);
  CHECK(layout.cell_count == 5);
  CHECK(layout.has(ColumnRole::time));
  CHECK(layout.quantities().size() == 4);
  for (const char mark : {';', '\t'}) {
    std::string headings = kHeadingsOfFive;
    std::ranges::replace(headings, ',', mark);
    CHECK_THROWS_WITH(layout_of(headings + "\n0" + mark + "1\n"),
                      Catch::Contains("uses commas as separator"));
  }
}

TEST_CASE("recognise_table: a stage and a time alone are not the headings of triax") {
  const auto layout = layout_of(
      "Stage,Time (min),Axial strain (%),q (kPa),p' (kPa)\n1,0,0.0,0.0,100.0\n1,1,0.5,20.0,106.7\n"
      "1,2,1.0,30.0,110.0\n1,3,1.5,36.0,112.0\n1,4,2.0,39.0,113.0\n");
  CHECK(layout.dialect.name == "table");
  CHECK(layout.quantities().size() == 3);
}

TEST_CASE("another unit of the same kind is converted, another kind is refused") {
  const auto layout = layout_of(
      "time_min,axial_strain_pct,deviator_stress_psi,mean_effective_stress_MPa\n0,0,0,1\n");
  CHECK(layout.columns[0].scale == 60);
  CHECK(layout.columns[1].scale == 0.01);
  CHECK(layout.columns[2].scale == Approx(6894.757));
  CHECK(layout.columns[3].scale == 1e6);
  CHECK_THROWS_WITH(layout_of("time_s,axial_force_kPa,cell_pressure_kPa\n0,1,1\n"),
                    Catch::Contains("is in 'kPa', which does not fit this quantity; known: kN, N"));
  CHECK_THROWS_WITH(layout_of("time_s,axial_force_foo,cell_pressure_kPa\n0,1,1\n"),
                    Catch::Contains("'foo', an unknown unit"));
  CHECK_THROWS_WITH(layout_of("time_s,axial_force,cell_pressure_kPa\n0,1,1\n"),
                    Catch::Contains("has no unit"));
}

TEST_CASE("a unit can stand in brackets, in a row of its own or in the dialect") {
  const auto dialect = parse_dialect(
      "name = \"d\"\n[columns]\naxial_strain = \"eps\"\n"
      "deviator_stress = { names = \"q\", unit = \"MPa\" }\nmean_effective_stress = \"p\"\n"
      "void_ratio = { names = \"e\", true_unit = \"\" }\n"
      "back_volume = { names = \"V\", unit = \"mm3\", sign = -1 }\n",
      "d.toml");
  const auto layout = layout_of("eps [%];q;p;e [%];V\n(-);;[kPa];[%];\n\n0,1;1;2;0,9;3\n", dialect);
  CHECK(layout.first_row_line == 3);
  CHECK(layout.columns[0].scale == 0.01);   // heading before units row
  CHECK(layout.columns[1].scale == 1e6);    // dialect
  CHECK(layout.columns[2].scale == 1e3);    // units row
  CHECK(layout.columns[3].scale == 1);      // true_unit before heading
  CHECK(layout.columns[4].scale == -1e-9);  // sign
}

TEST_CASE("what cannot be a record is refused in one line") {
  const std::pair<std::string, std::string> wrong[] = {
      {"", "m.csv: the file is empty"},
      {"\n \n", "the file is empty"},
      {kHeadingsOfFive + "\n", "m.csv:1: headings without a row"},
      {"a\n1\n2\n", "m.csv: only one column found"},
      {"a|b|c\n1|2|3\n",
       "m.csv:1: no dialect fits this file; headings found: 'a', 'b', 'c' (3 "
       "columns separated by pipe, rows from line 2)"},
      {"0,1,2\n1,2,3\n", "m.csv: no dialect fits this file; found: 3 columns of numbers and no"},
      {"Dear all\nsee below\n", "m.csv: no dialect fits this file; found: only text"},
      {"alpha,beta\n1,2\n", "m.csv:1: no dialect fits this file; headings found: 'alpha', 'beta'"},
      {"time_s,axial_displacement_mm,cell_pressure_kPa\n0,1,2\n", "also needs axial_force_kN"},
      {kHeadingsOfFive + ",cell_pressure_psi\n0,1,2,3,4,5\n", "m.csv:1: two columns are the same"},
      {kHeadingsOfFive + ",time_s\n0,1,2,3,4,5\n", "two columns are the same"},
      {"time_s,axial_displacement_mm,axal_force_kN,cell_pressure_kPa\n0,1,2,3\n",
       "did you mean 'axial_force_kN'"}};
  for (const auto& [text, message] : wrong) {
    INFO(text);
    CHECK_THROWS_WITH(layout_of(text), Catch::Contains(message));
  }
}

TEST_CASE("an unknown column is left out and said") {
  std::vector<Warning> warnings;
  const auto layout =
      layout_of(kHeadingsOfFive + ",pore_presure_kPa\n0,1,2,3,4,5\n", {}, &warnings);
  CHECK(layout.quantities().size() == 4);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0].text, Catch::Contains("did you mean 'pore_pressure_kPa'"));
}

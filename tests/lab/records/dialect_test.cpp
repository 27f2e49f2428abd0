// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/dialect.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

TEST_CASE("the shipped dialects are valid and there by name, our own first") {
  CHECK(shipped_dialects().front().name == "triax");
  for (const char* name : {"triax", "gdslab", "karlsruhe", "nerlerk", "cyclic"}) {
    const Dialect dialect = find_dialect(name);
    CHECK(dialect.name == name);
    CHECK_FALSE(dialect.about.empty());
  }
  CHECK_THROWS_WITH(find_dialect("gds_lab"), Catch::Contains("did you mean 'gdslab'"));
}

TEST_CASE("a dialect says columns, units, signs, keys and defaults") {
  const auto dialect = parse_dialect(
      "name = \"d\"\n[recognise]\nheadings = [\"a\"]\n[table]\nseparator = \";\"\ndecimal = \",\"\n"
      "[columns]\ntime = { names = \"t\", unit = \"min\" }\n"
      "back_volume = { names = [\"V\", \"Vol\"], unit = \"cm3\", sign = -1 }\n"
      "[specimen]\nheight_mm = \"H\"\n[defaults]\ndrainage = \"closed\"\ncontrol = \"load\"\n",
      "d.toml");
  CHECK(dialect.separator == Separator::semicolon);
  CHECK(dialect.decimal == DecimalMark::comma);
  REQUIRE(dialect.columns.size() == 2);
  CHECK(dialect.columns[0].role == ColumnRole::time);
  CHECK(dialect.columns[1].quantity == Quantity::back_volume);
  CHECK(dialect.columns[1].names == std::vector<std::string>{"V", "Vol"});
  CHECK(dialect.columns[1].sign == -1);
  CHECK(dialect.keys.front().key == "specimen.height_mm");
  CHECK(dialect.stage.drainage == Drainage::closed);
  CHECK(dialect.stage.control == AxialControl::load);
  CHECK(dialect.stage.role == StageRole::shear);
}

TEST_CASE("what is wrong in a dialect is named with its line and the nearest right word") {
  const std::string name = "name = \"d\"\n";
  const std::string column = name + "[columns]\naxial_strain = \"e\"\n";
  const std::pair<std::string, std::string> wrong[] = {
      {column + "[tabel]\n", "d.toml:4: unknown key 'tabel'; did you mean 'table'"},
      {column + "[table]\nseperator = \";\"\n", "d.toml:5: unknown key 'seperator'"},
      {column + "[table]\nseparator = \"#\"\n",
       "d.toml:5: [table] separator: '#' is not a separator"},
      {name + "[columns]\naxial_strian = \"e\"\n", "did you mean 'axial_strain'"},
      {name + "[columns]\nq = \"q\"\n", "d.toml:3: unknown key 'q' in [columns]"},
      {name + "[columns]\naxial_strain = { names = \"e\", unit = \"kPa\" }\n", "does not fit"},
      {name + "[columns]\naxial_strain = { names = \"e\", unit = \"foo\" }\n", "unknown unit"},
      {name + "[columns]\naxial_strain = { names = \"e\", sign = 2 }\n", "1 or -1"},
      {name + "[columns]\naxial_strain = { unit = \"%\" }\n", "needs the heading"},
      {column + "[specimen]\nhight_mm = \"H\"\n", "did you mean 'specimen.height_mm'"},
      {column + "[defaults]\nrole = \"sheer\"\n", "d.toml:5: stages.1.role = 'sheer'"},
      {name, "a dialect needs [columns]"},
      {"[columns]\naxial_strain = \"e\"\n", "a dialect needs a name"}};
  for (const auto& [toml, message] : wrong) {
    INFO(toml);
    CHECK_THROWS_WITH(parse_dialect(toml, "d.toml"), Catch::Contains(message));
  }
}

TEST_CASE("names match without case, a trailing star matches any rest") {
  CHECK(matches_name(" Axial  Strain", "axial strain"));
  CHECK(matches_name("AXIAL STRAIN  EXCESS PWP", "Axial Strain*"));
  CHECK_FALSE(matches_name("Axial Strain 2", "Axial Strain"));
  CHECK(matches_name("anything", "*"));
  CHECK(may_match(" Axial", "a"));
  CHECK_FALSE(may_match("Axial", "q"));
}

TEST_CASE("Dialect: a number in [specimen] or [test] is the value, a text a label") {
  const auto dialect = parse_dialect(
      "name = \"d\"\n[columns]\naxial_strain = \"e\"\n[specimen]\nheight_mm = 76\n"
      "diameter_mm = \"D\"\n[test]\ncell_pressure_kPa = 300.5\n",
      "d.toml");
  REQUIRE(dialect.keys.size() == 3);
  for (const DialectKey& key : dialect.keys) {
    INFO(key.key);
    CHECK(key.value == (key.key == "specimen.height_mm"     ? "76"
                        : key.key == "specimen.diameter_mm" ? ""
                                                            : "300.5"));
    CHECK(key.labels.empty() == (key.key != "specimen.diameter_mm"));
  }
  CHECK_THROWS_WITH(
      parse_dialect("name = \"d\"\n[columns]\naxial_strain = \"e\"\n[specimen]\nheight_mm = -7\n",
                    "d.toml"),
      Catch::StartsWith("d.toml:5: "));
}

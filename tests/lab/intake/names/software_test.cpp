// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/software.hpp"

#include <catch2/catch.hpp>

#include "lab/intake/names/lexicon.hpp"
#include "lab/intake/names/lexicon_file.hpp"

using namespace triax::lab;

namespace {

std::string software_name(const std::vector<std::string>& headings, std::string_view head = {}) {
  const Software* const software = find_software(headings, head);
  return software ? software->name : "";
}

}  // namespace

TEST_CASE("find_software: headings identify the software, with or without units") {
  CHECK(software_name({"Stage Number", "Time since start of stage (s)", "Radial Pressure (kPa)",
                       "Axial Strain (%)"}) == "GDSLab");
  CHECK(software_name({"Action", "Action_Changed", "Trajectory", "Deviator_kPa"}) ==
        "NPP Geotek ASIS");
  CHECK(software_name({"Action", "Action_Changed", "Trajectory"}).empty());
  CHECK(software_name({"Load_(N)", "Disp.(mm)", "Cell_P.(kPa)", "SP.Vol.(mm3)"}) ==
        "DigitShowBasic");
  CHECK(software_name({"Axial strain (%)", "q (kPa)"}).empty());
  CHECK(software_name({}).empty());
}

TEST_CASE("find_software: the first cell and a text of the first lines identify it, too") {
  CHECK(software_name({"Time"}, "\"TOA5\",\"CR1000\"") == "Campbell TOA5");
  CHECK(software_name({}, "\xEF\xBB\xBFLabVIEW Measurement\t\n") == "LabVIEW measurement file");
  CHECK(software_name({}, "Name\nAlarm 101\n") == "BenchLink");
  CHECK(software_name({}, "a TOA5").empty());
}

TEST_CASE("find_software_column: gives sign, unit and quantity of a column") {
  const Software* const gds =
      find_software({"Stage Number", "Time since start of stage", "Radial Pressure"});
  REQUIRE(gds);
  const SoftwareColumn* const volume = find_software_column(*gds, "Volume Change (mm³)");
  REQUIRE(volume);
  CHECK(volume->sign == -1);
  CHECK(find_software_column(*gds, "Eff. Stress Ratio (%)")->unit == "-");
  CHECK_FALSE(find_software_column(*gds, "Axial Strain"));
  CHECK(gds->labels.front().heading == "Specific Gravity");
  const Software* const rig = find_software({"e1", "tau", "s3", "ev"});
  REQUIRE(rig);
  CHECK(find_software_column(*rig, "tau")->quantity == "half_deviator_stress");
}

TEST_CASE("software.toml: its headings are names and its quantities exist") {
  for (const TomlTable& row : read_lexicon_file("software").tables("software")) {
    INFO(row.required_text("name"));
    for (const TomlTable& column : row.tables("columns"))
      CHECK(find_lexicon_quantity(column.text("quantity").value_or("time")));
    if (!row.flag("holds_readings").value_or(true)) continue;
    std::vector<std::string> headings = row.texts("headings");
    for (const std::string& heading : row.texts("any")) headings.push_back(heading);
    for (const TomlTable& column : row.tables("columns"))
      headings.push_back(column.required_text("heading"));
    for (const std::string& heading : headings) {
      INFO(heading);
      CHECK_FALSE(find_names(heading).candidates.empty());
    }
  }
}

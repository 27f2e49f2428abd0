// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/record_head.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "lab/records/tables/table_recognition.hpp"

using namespace triax::lab;

namespace {
struct Head {
  std::vector<Warning> warnings;
  Findings findings{warnings};
  RecordHeader header;
  TableLayout layout;
  explicit Head(const std::string& text, const std::optional<Dialect>& dialect = {}) {
    const auto source = open_memory("folder/my test.csv", text);
    layout = recognise_table(*source, dialect, findings);
    describe_record(header, layout, findings);
  }
};
}  // namespace

TEST_CASE("the preamble is read by the dialect's labels, in the file's units") {
  const auto dialect = parse_dialect(
      "name = \"d\"\n[columns]\naxial_strain = \"eps\"\ndeviator_stress = \"q\"\n"
      "mean_effective_stress = \"p\"\n[test]\nprogramme = \"Type\"\n[specimen]\n"
      "height_mm = \"Height\"\ndiameter_mm = \"Diameter\"\nmaterial = \"Soil\"\n",
      "d.toml");
  const Head head(
      "Type:;CID;Soil;fine sand\nHeight (cm):;14,5\nDiameter (mm);unknown\neps;q (kPa);p (kPa)\n"
      "0;0;100\n",
      dialect);
  CHECK(head.header.name == "my test");
  CHECK(head.header.dialect == "d");
  CHECK(head.header.programme == "CID");
  CHECK(head.header.specimen.material == "fine sand");
  CHECK(*head.header.specimen.height_m == Approx(0.145));
  CHECK_FALSE(head.header.specimen.diameter_m);
  CHECK_FALSE(head.header.has_time);
  REQUIRE(head.warnings.size() == 2);
  CHECK(head.warnings[0].line == 3);
  CHECK_THAT(head.warnings[1].text, Catch::Contains("no time column"));
  CHECK(single_stage(head.layout, head.header.programme).drainage == Drainage::open);
}

TEST_CASE("our preamble is TOML behind #, line for line") {
  const Head head(
      "# [test]\n\n# name = \"x\"\ntime_s,axial_strain,deviator_stress_kPa,"
      "mean_effective_stress_kPa\n0,0,0,1\n");
  CHECK(toml_preamble(head.layout) == "[test]\n\nname = \"x\"\n");
}

TEST_CASE("the drainage of a single stage follows programme, then columns") {
  const auto dialect = parse_dialect(
      "name = \"d\"\n[columns]\naxial_strain = \"eps\"\ndeviator_stress = \"q\"\n"
      "mean_effective_stress = \"p\"\npore_pressure = \"u\"\nvolumetric_strain = \"v\"\n",
      "d.toml");
  const auto drainage = [&](const std::string& headings, std::string_view programme) {
    const Head head(headings + "\n(-),(kPa),(kPa),(kPa)\n0,0,1,1\n", dialect);
    return single_stage(head.layout, programme).drainage;
  };
  CHECK(drainage("eps,q,p,u", "") == Drainage::closed);
  CHECK(drainage("eps,q,p,u", "CID") == Drainage::open);
  CHECK(drainage("eps,q,p,x", "") == Drainage::unknown);
  CHECK(drainage("eps,q,p,x", "CIU") == Drainage::closed);
  CHECK(drainage("eps,q,p,u", "CADC") == Drainage::open);
  CHECK(drainage("eps,q,p,x", "CAUE") == Drainage::closed);
  CHECK(drainage("eps,q,p,x", "sand") == Drainage::unknown);  // no type ends so by chance
}

TEST_CASE("describe_record: a held cell pressure from a label or from the dialect") {
  const std::string columns =
      "name = \"d\"\n[columns]\naxial_displacement = \"s\"\naxial_force = \"F\"\n";
  const std::string rows = "s (mm);F (N)\n0;1\n";
  const auto labelled = parse_dialect(columns + "[test]\ncell_pressure_kPa = \"Cell\"\n", "d.toml");
  CHECK(*Head("Cell (bar);2,5\n" + rows, labelled).header.cell_pressure_pa == Approx(250e3));
  const auto constant = parse_dialect(columns + "[defaults]\ncell_pressure_kPa = 300\n", "d.toml");
  CHECK(*Head(rows, constant).header.cell_pressure_pa == Approx(300e3));
  CHECK_THROWS_WITH(parse_dialect(columns + "[defaults]\ncell_pressure_kPa = -1\n", "d.toml"),
                    Catch::Contains("d.toml:6") && Catch::Contains("out of range"));
}

TEST_CASE("describe_record: dimensions that are not used are reported") {
  const std::string rows =
      "Axial strain (%),q (kPa),u (kPa),Cell pressure (kPa)\n0,0,200,400\n1,50,230,400\n"
      "2,70,250,400\n3,80,255,400\n";
  const auto has = [](const Head& head, const std::string& text) {
    return std::ranges::any_of(head.warnings, [&](const Warning& warning) {
      return warning.text.find(text) != std::string::npos;
    });
  };
  const Head consolidated("Height after consolidation: 75.5 mm\nCorrected area: 11.25 cm2\n" +
                          rows);
  CHECK(consolidated.header.specimen.consolidated_height_m == Approx(0.0755));
  CHECK(has(consolidated, "consolidated_area = 1125 mm2 is not used"));
  const Head twice("Height: 76 mm\nHeight: 80 mm\n" + rows);
  CHECK_FALSE(twice.header.specimen.height_m);
  CHECK(has(twice, "height = 76 is not used"));
}

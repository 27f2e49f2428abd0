// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/sheet_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "lab/base/bad_input.hpp"
#include "lab/base/digest.hpp"
#include "tests/lab/rig/rig_text.hpp"
#include "tests/lab/workbook/made_workbook.hpp"

using namespace triax::lab;
using namespace triax::lab::test;

namespace {

std::string cell(const std::string& text) {
  return "<c t=\"inlineStr\"><is><t>" + text + "</t></is></c>";
}

std::string own_rows() {
  return "<row>" + cell("axial_strain") + cell("deviator_stress_kPa") +
         cell("mean_effective_stress_kPa") +
         "</row><row><c><v>0</v></c><c><v>0</v></c><c><v>100</v></c></row>"
         "<row><c><v>0.10000000000000001</v></c><c><v>5</v></c>" +
         cell("101,5") + "</row>";
}

/// Numbers as such, all else as text.
std::string row(const std::vector<std::string>& cells) {
  std::string out = "<row>";
  for (const std::string& text : cells) {
    const bool is_number = !text.empty() && text.find_first_not_of("0123456789.") == text.npos;
    out += is_number ? "<c><v>" + text + "</v></c>" : cell(text);
  }
  return out + "</row>";
}

const std::vector<std::string> kRawHeadings{"Axial displacement (mm)", "Axial load (N)",
                                            "Cell pressure (kPa)", "Pore pressure (kPa)"};

std::string raw_sheet(const std::vector<std::string>& headings, double cell_kPa) {
  std::string out = row(headings);
  for (int i = 0; i < 20; ++i)
    out += row({fmt::format("{:.2f}", 0.4 * i), fmt::format("{:.1f}", 200.0 * i / (i + 4)),
                fmt::format("{:g}", cell_kPa), fmt::format("{:.1f}", 300 + 60.0 * i / (i + 6))});
  return sheet(out);
}

const std::string kSpecimenRows = row({"Height (mm)", "76.2"}) + row({"Diameter (mm)", "38.1"});

bool has_warning(const RecordHeader& header, const std::string& text) {
  return std::ranges::any_of(header.warnings, [&](const Warning& warning) {
    return warning.text.find(text) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("Record of a workbook: labels of another sheet are used") {
  const auto parts = workbook(
      {{"Specimen data", sheet(kSpecimenRows)}, {"Readings", raw_sheet(kRawHeadings, 500)}});
  const auto rig = open_record(source_of(parts), {});
  CHECK(rig->header().specimen.height_m == Approx(0.0762));
  CHECK(rig->header().specimen.diameter_m == Approx(0.0381));
  CHECK(has_warning(rig->header(), "specimen.height_mm = 76.2 is from another worksheet"));
}

TEST_CASE("Record of a workbook: a sheet is read with the factors of another one") {
  const auto parts = workbook(
      {{"Constants", sheet(kSpecimenRows + row({"Load ring constant", "1.25", "N/div"}) +
                           row({"Dial gauge", "0.01", "mm/div"}))},
       {"Readings",
        raw_sheet({"Dial gauge (div)", "Load ring (div)", kRawHeadings[2], kRawHeadings[3]},
                  500)}});
  const auto rig = open_record(source_of(parts), {});
  const auto all = all_readings(*rig);
  REQUIRE(all.size() == 20);
  CHECK(all[5][Quantity::axial_displacement] == Approx(2.0e-5));
  CHECK(all[4][Quantity::axial_force] == Approx(1.25 * 100));
}

TEST_CASE("tests_in: each sheet with the same headings is a test") {
  const auto parts = workbook({{"Data", sheet(kSpecimenRows)},
                               {"Consolidation", raw_sheet(kRawHeadings, 450)},
                               {"CU1", raw_sheet(kRawHeadings, 500)},
                               {"CU2", raw_sheet(kRawHeadings, 600)}});
  const auto open = [&]() -> std::unique_ptr<ByteSource> { return source_of(parts); };
  const auto tests = std::make_shared<const TestsInFile>(tests_in(open, {}));
  REQUIRE(tests->names == std::vector<std::string>{"worksheet 'CU1'", "worksheet 'CU2'"});
  const auto rig = open_record(open(), {.test = 2, .tests = tests});
  CHECK(all_readings(*rig).front()[Quantity::cell_pressure] == Approx(600e3));
  CHECK(rig->header().specimen.height_m == Approx(0.0762));
  CHECK(has_warning(rig->header(), "readings are also in 'CU1', 'Consolidation'"));
  CHECK(tests_in(open, {.sheet = "CU1"}).names.empty());
}

TEST_CASE("Record of a workbook: a sheet that lacks a value is named, not the first one") {
  std::vector<std::string> headings = kRawHeadings;
  headings[1] = "Axial load";
  const auto parts = workbook(
      {{"Summary", sheet(row({"phi'", "34.9", "deg"}))}, {"Readings", raw_sheet(headings, 500)}});
  CHECK_THROWS_WITH(open_record(source_of(parts), {}),
                    Catch::Contains("the file does not decide: unit of Axial load"));
}

TEST_CASE("a sheet is a record: the first that is recognised, numbers to the last bit") {
  const auto parts = workbook(
      {{"Notes", sheet("<row>" + cell("nothing") + "</row>")}, {"Data", sheet(own_rows())}});
  const auto rig = open_record(source_of(parts), {});
  const auto all = all_readings(*rig);
  REQUIRE(all.size() == 2);
  CHECK(all[1][Quantity::axial_strain] == 0.1);
  CHECK(all[1][Quantity::mean_effective_stress] == 101.5e3);
  CHECK(all[1].line == 3);  // the row of the sheet
  CHECK(rig->header().digest == sha256(*source_of(parts)));
  bool names_sheet = false;
  for (const auto& warning : rig->header().warnings)
    names_sheet |= warning.text.find("sheet 'Data'") != std::string::npos;
  CHECK(names_sheet);
}

TEST_CASE("cells that are shown in per cent mean what is shown, under either heading") {
  for (const char* const heading : {"axial_strain (%)", "axial_strain"}) {
    const auto rows = "<row>" + cell(heading) + cell("deviator_stress_kPa") +
                      cell("mean_effective_stress_kPa") +
                      "</row><row><c s=\"5\"><v>0</v></c><c><v>0</v></c><c><v>100</v></c></row>"
                      "<row><c s=\"5\"><v>0.05</v></c><c><v>5</v></c><c><v>101</v></c></row>";
    const auto rig = open_record(source_of(workbook({{"Data", sheet(rows)}})), {});
    const auto all = all_readings(*rig);
    REQUIRE(all.size() == 2);
    CHECK(all[1][Quantity::axial_strain] == Approx(0.05));
  }
  // Of a stress it says nothing.
  const auto rows = "<row>" + cell("axial_strain") + cell("deviator_stress_kPa") +
                    cell("mean_effective_stress_kPa") +
                    "</row><row><c><v>0</v></c><c s=\"5\"><v>0.4</v></c><c><v>100</v></c></row>";
  CHECK_THROWS_WITH(open_record(source_of(workbook({{"Data", sheet(rows)}})), {}),
                    Catch::Contains("'40%', which is not a number"));
}

TEST_CASE("a cell with an error under our own headings is refused by its row") {
  const auto rows =
      own_rows() + "<row><c><v>0.2</v></c><c t=\"e\"><v>#N/A</v></c><c><v>9</v></c></row>";
  CHECK_THROWS_WITH(
      [&] {
        const auto rig = open_record(source_of(workbook({{"Data", sheet(rows)}})), {});
        all_readings(*rig);
      }(),
      Catch::Contains("m.xlsx:4: column 'deviator_stress_kPa' has '#N/A'"));
}

TEST_CASE("a sheet that is asked for, one that is not there, none that fits") {
  const auto parts = workbook({{"A", sheet(own_rows())}, {"B", sheet(own_rows())}});
  CHECK_NOTHROW(open_record(source_of(parts), {.sheet = "B"}));
  CHECK_THROWS_WITH(open_record(source_of(parts), {.sheet = "C"}), Catch::Contains("'A', 'B'"));
  const auto none = workbook({{"A", sheet("")}, {"B", sheet("<row>" + cell("x") + "</row>")}});
  CHECK_THROWS_WITH(open_record(source_of(none), {}),
                    Catch::Contains("no readings recognised in its 2 worksheets"));
}

TEST_CASE("a dialect names sheet and cells") {
  const auto path = std::filesystem::temp_directory_path() / "triax_sheet_dialect.toml";
  std::ofstream(path)
      << "name = \"mine\"\n[table]\nsheet = \"Versuch*\"\n[columns]\n"
         "axial_strain = { names = \"axial_strain\", unit = \"\" }\n"
         "deviator_stress = { names = \"deviator_stress_kPa\", unit = \"kPa\" }\n"
         "mean_effective_stress = { names = \"mean_effective_stress_kPa\", unit = \"kPa\" }\n"
         "[specimen]\nheight_mm = \"Tabelle!B2\"\n";
  const auto parts = workbook({{"Tabelle", sheet("<row r=\"2\"><c r=\"B2\"><v>98.5</v></c></row>")},
                               {"Versuch01", sheet(own_rows())}});
  const auto rig = open_record(source_of(parts), {.dialect = path.string()});
  std::filesystem::remove(path);
  REQUIRE(rig->header().specimen.height_m);
  CHECK(*rig->header().specimen.height_m == Approx(0.0985));
}

TEST_CASE("a workbook of others reads as its sheet saved as CSV", "[of-others]") {
  const std::filesystem::path folder = "../shared/data/tuhh";
  if (!std::filesystem::exists(folder / "Triax-CU_01.xlsx")) {
    std::cout << "skipped: no workbook of others beside the checkout\n";
    return;
  }
  const RecordOptions options{
      .sets = {{"specimen.height_mm", "100"}, {"specimen.diameter_mm", "50"}}};
  const auto sheet = open_record((folder / "Triax-CU_01.xlsx").string(), options);
  const auto csv = open_record((folder / "Triax-CU_01__Versuch01.csv").string(), options);
  const auto a = all_readings(*sheet), b = all_readings(*csv);
  REQUIRE(a.size() == b.size());
  REQUIRE(a.size() > 100);
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].time_s == Approx(b[i].time_s).margin(1));
    for (std::size_t q = 0; q < kQuantityCount; ++q)
      CHECK(((std::isnan(a[i].si[q]) && std::isnan(b[i].si[q])) || a[i].si[q] == b[i].si[q]));
  }
}

TEST_CASE("Record of a text: the encoding is found, reported and can be given") {
  const std::string dialect =
      "name = \"d\"\n[table]\nencoding = \"cp1251\"\n[columns]\n"
      "axial_strain = { names = \"Деформация\", unit = \"%\" }\n"
      "deviator_stress = { names = \"q\", unit = \"kPa\" }\n"
      "mean_effective_stress = { names = \"p\", unit = \"kPa\" }\n";
  const auto path = std::filesystem::temp_directory_path() / "triax_encoding.toml";
  std::ofstream(path) << dialect;
  const std::string rows = "\xC4\xE5\xF4\xEE\xF0\xEC\xE0\xF6\xE8\xFF;q;p\n0,0;0;100\n0,1;5;101,5\n";
  const auto rig = open_record(open_memory("m.csv", rows), {.dialect = path.string()});
  CHECK(all_readings(*rig).size() == 2);
  CHECK(std::ranges::any_of(rig->header().warnings, [](const Warning& warning) {
    return warning.text == "not UTF-8: read as Windows-1251";
  }));
  CHECK(rig->header().digest == sha256(*open_memory("m", rows)));
  CHECK_THROWS_WITH(open_record(open_memory("m.csv", rows),
                                {.dialect = path.string(), .encoding = "Windows-1252"}),
                    Catch::Contains("channels are missing"));
  CHECK_THROWS_WITH(open_record(open_memory("m.csv", rows), {.dialect = {}, .encoding = "cp99"}),
                    Catch::Contains("m.csv: encoding 'cp99' is not valid"));
  std::filesystem::remove(path);
}

TEST_CASE("Record of a text: UTF-16 and lines that end with CR are read") {
  const std::string text =
      "axial_strain,deviator_stress_kPa,mean_effective_stress_kPa\r0,0,100\r0.1,5,101.5\r";
  std::string wide = "\xFF\xFE";
  for (const char c : text) wide.append({c, '\0'});
  for (const std::string& bytes : {text, wide}) {
    const auto rig = open_record(open_memory("m.csv", bytes), {});
    const auto all = all_readings(*rig);
    REQUIRE(all.size() == 2);
    CHECK(all[1].si[index(Quantity::mean_effective_stress)] == 101500);
    const auto is_reported = std::ranges::any_of(rig->header().warnings, [](const Warning& one) {
      return one.text == "not UTF-8: read as UTF-16LE";
    });
    CHECK(is_reported == (bytes == wide));
  }
}

TEST_CASE("Record: a file that is no table is named, a table by its separator") {
  CHECK_THROWS_WITH(open_record(open_memory("a.csv", "%PDF-1.7\n"), {}),
                    Catch::Contains("a.csv: this is a PDF document"));
  CHECK_THROWS_WITH(open_record(open_memory("a.xls", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"), {}),
                    Catch::Contains("save it as .xlsx"));
  CHECK_THROWS_WITH(
      open_record(open_memory("logger.txt",
                              "INDEX, TIME STAMP, TIME (ms), DEV 1 INPUT 1,\r\n"
                              "0,3/7/2026 10:02:15,500,0.02,\r\n"
                              "1,3/7/2026 10:02:15,1000,0.42,\r\n"),
                  {}),
      Catch::Contains("logger.txt:1: no dialect fits this file") &&
          Catch::Contains(
              "'INDEX', 'TIME STAMP', 'TIME (ms)', 'DEV 1 INPUT 1' (4 columns separated "
              "by comma, rows from line 2)"));
}

// SPDX-License-Identifier: GPL-3.0-or-later
// One test as a file of triax, a table of another laboratory, a workbook, a table with codes of AGS
// and a DIGGS file.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.hpp"
#include "tests/lab/workbook/made_workbook.hpp"

using namespace triax::cli_tests;

namespace {

/// Cells of an undrained test of loose sand: time in s, displacement in mm, force in N, pressures
/// in kPa.
using Cells = std::vector<std::string>;
std::vector<Cells> cells_of_test() {
  constexpr int kReadings = 120;
  constexpr double kArea_mm2 = 3848.451;
  std::vector<Cells> rows;
  for (int i = 0; i < kReadings; ++i) {
    const double strain = 0.001 * i;
    const double q = 95 * std::tanh(400 * strain) * (0.15 + 0.85 * std::exp(-35 * strain));
    const double u = 200 + 85 * (1 - std::exp(-120 * strain));
    rows.push_back({fmt::format("{}", 10 * i), fmt::format("{:.3f}", 140 * strain),
                    fmt::format("{:.2f}", q * kArea_mm2 / (1 - strain) / 1000), "300.0",
                    fmt::format("{:.2f}", u)});
  }
  return rows;
}

std::string with_comma(std::string cell) {
  if (const auto mark = cell.find('.'); mark != std::string::npos) cell[mark] = ',';
  return cell;
}

std::string own_file() {
  std::string out =
      "time_s,axial_displacement_mm,axial_force_N,cell_pressure_kPa,pore_pressure_kPa\n";
  for (const Cells& row : cells_of_test())
    out += fmt::format("{},{},{},{},{}\n", row[0], row[1], row[2], row[3], row[4]);
  return out;
}

std::string foreign_table() {
  std::string out =
      "Auftrag;2026-17\n\nPorendruck [kPa];Versuchszeit [s];Stauchung [mm];Axialkraft [N];"
      "Zelldruck [kPa];Temperatur [°C]\n";
  for (const Cells& row : cells_of_test())
    out += fmt::format("{};{};{};{};{};20,1\n", with_comma(row[4]), row[0], with_comma(row[1]),
                       with_comma(row[2]), with_comma(row[3]));
  return out;
}

std::string ags_table() {
  std::string out =
      "\"HEADING\",\"TREL_TTIM\",\"Axial displacement\",\"Axial force\",\"TREL_CELL\","
      "\"TREL_PWP\"\n\"UNIT\",\"s\",\"mm\",\"N\",\"kPa\",\"kPa\"\n"
      "\"TYPE\",\"0DP\",\"3DP\",\"2DP\",\"1DP\",\"2DP\"\n";
  for (const Cells& row : cells_of_test())
    out += fmt::format("\"DATA\",\"{}\",\"{}\",\"{}\",\"{}\",\"{}\"\n", row[0], row[1], row[2],
                       row[3], row[4]);
  return out;
}

/// Headings of another laboratory below two lines of text, the readings as numbers.
std::string workbook() {
  const auto text = [](const char* content) {
    return fmt::format("<c t=\"inlineStr\"><is><t>{}</t></is></c>", content);
  };
  std::string rows =
      fmt::format("<row r=\"1\">{}{}</row><row r=\"3\">", text("Borehole"), text("BH 7"));
  for (const char* heading : {"Elapsed time (s)", "Vertical displacement (mm)", "Load (N)",
                              "Cell pressure (kPa)", "Pore pressure (kPa)"})
    rows += text(heading);
  rows += "</row>";
  std::size_t line = 4;
  for (const Cells& cells : cells_of_test()) {
    rows += fmt::format("<row r=\"{}\">", line++);
    for (const std::string& cell : cells) rows += fmt::format("<c><v>{}</v></c>", cell);
    rows += "</row>";
  }
  namespace made = triax::lab::test;
  return made::zipped(made::workbook({{"Data", made::sheet(rows)}}));
}

struct Assessed {
  nlohmann::json collapse;
  std::string states;  ///< as CSV
};

Assessed assessed(const Workplace& here, const std::string& file, const std::string& options) {
  INFO(file);
  const std::string db = " --db " + file + ".db";
  const auto out = here.triax("replay " + file + db + options);
  INFO(out.err);
  REQUIRE(out.status == 0);
  const auto report = nlohmann::json::parse(here.triax("report 1 --format json" + db).out);
  REQUIRE(
      here.triax("export 1 --states --output " + file + ".states.csv --format csv" + db).status ==
      0);
  return {report["collapse"], content(here / (file + ".states.csv"))};
}

}  // namespace

TEST_CASE("replay: five routes give the same assessment to the bit") {
  const Workplace here;
  const std::string options =
      " --set specimen.height_mm=140 --set specimen.diameter_mm=70"
      " --set specimen.limit_friction_angle_deg=33 --set test.programme=CIU";
  write(here / "own.csv", own_file());
  write(here / "foreign.csv", foreign_table());
  write(here / "ags.csv", ags_table());
  write(here / "book.xlsx", workbook());
  const Assessed own = assessed(here, "own.csv", options);
  CHECK(own.collapse.dump().find("flow") != std::string::npos);
  REQUIRE(here.triax("export 1 --db own.csv.db --output diggs.xml").status == 0);
  for (const std::string file : {"foreign.csv", "ags.csv", "diggs.xml", "book.xlsx"}) {
    const Assessed other = assessed(here, file, file == "diggs.xml" ? "" : options);
    INFO(file);
    CHECK(other.collapse == own.collapse);
    CHECK((other.states == own.states));
  }
}

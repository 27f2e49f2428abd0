// SPDX-License-Identifier: GPL-3.0-or-later
// A UU test from its record to sheet, JSON and AGS4, all of one c_u.
#include <catch2/catch.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;

namespace {

/// q = 400 kPa · ε₁ to 25 %, at 1 %/min, without a pore pressure: F = q A_0/(1 − ε₁).
std::string rising_record(const std::string& programme) {
  std::string text = "# [test]\n# programme = \"" + programme +
                     "\"\n# [specimen]\n# height_mm = 100\n# diameter_mm = 50\n"
                     "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa\n";
  constexpr double kArea_m2 = 1.9634954084936207e-3;
  for (int i = 0; i <= 250; ++i) {
    const double strain = 1e-3 * i;
    char row[120];
    std::snprintf(row, sizeof row, "%d,%.1f,%.17g,300\n", 6 * i, 0.1 * i,
                  400 * strain * kArea_m2 / (1 - strain));
    text += row;
  }
  return text;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a UU record without a pore pressure: c_u at 20 % in sheet, JSON and AGS4") {
  const Workplace here;
  write(here / "uu.csv", rising_record("UU"));
  REQUIRE(here.triax("replay uu.csv").status == 0);
  const auto report = here.triax("report 1 --format json --failure peak-q");
  REQUIRE(report.status == 0);
  const auto failure = nlohmann::json::parse(report.out)["sheet"]["failure"];
  CHECK(failure["axial_strain"].get<double>() == Approx(0.2));
  CHECK(failure["undrained_strength_kPa"].get<double>() == Approx(40));
  REQUIRE(here.triax("report 1 --output uu.html").status == 0);
  const auto page = content(here / "uu.html");
  CHECK(page.find("Unconsolidated undrained triaxial test") != std::string::npos);
  CHECK(page.find("ISO 17892-8") != std::string::npos);
  CHECK(count(page, ">40.0<") == 1);
  CHECK(page.find("Saturation") == std::string::npos);
  REQUIRE(here.triax("export 1 --format ags --output uu.ags").status == 0);
  const auto ags = content(here / "uu.ags");
  CHECK(ags.find("\"300\",\"80\",\"20\",\"40\",\"1.0\"") != std::string::npos);
  CHECK(ags.find("TREG") == std::string::npos);
}

TEST_CASE("the same record of another type is refused, with what to say") {
  const Workplace here;
  write(here / "ciu.csv", rising_record("CIU"));
  const auto refused = here.triax("replay ciu.csv");
  CHECK(refused.status == 2);
  CHECK(count(refused.err, "\n") == 1);
  CHECK(refused.err.find("--set test.programme=UU") != std::string::npos);
  CHECK(here.triax("replay ciu.csv --set test.programme=UU").status == 0);
}

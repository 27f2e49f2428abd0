// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/column_consistency.hpp"

#include <cmath>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "lab/records/table_reader.hpp"
#include "lab/records/tables/table_recognition.hpp"

using namespace triax::lab;

namespace {

std::vector<Warning> contradictions(const std::string& text) {
  const auto source = open_memory("m.csv", text);
  std::vector<Warning> warnings;
  Findings findings(warnings);
  const TableLayout layout = recognise_table(*source, {}, findings);
  warnings.clear();
  TableReader reader(*source, layout, findings);
  Row row;
  while (reader.next(row)) {
  }
  findings.finish();
  std::erase_if(warnings, [](const Warning& warning) {
    return warning.text.find("contradict") == std::string::npos;
  });
  return warnings;
}

/// The contradictions of two rows of which the second has one value changed.
std::vector<Warning> in_second_row(const std::string& headings, const std::string& first,
                                   const std::string& second) {
  return contradictions(headings + "\n" + first + "\n" + second + "\n");
}

const std::string kStresses =
    "axial_strain (%),deviator_stress_kPa,mean_effective_stress_kPa,effective_axial_stress_kPa,"
    "effective_radial_stress_kPa,stress_ratio";

}  // namespace

TEST_CASE("ColumnConsistency: names line, columns and values of a contradiction") {
  const auto found =
      in_second_row(kStresses, "0,0.0,100.0,100.0,100.0,0.000", "1,80.0,90.0,123.3,73.3,0.556");
  REQUIRE(found.size() == 2);
  CHECK(found[0].line == 3);
  CHECK_THAT(
      found[0].text,
      Catch::Contains("'deviator_stress_kPa' has 80, but σ₁′ − σ₃′") &&
          Catch::Contains("'effective_axial_stress_kPa' and 'effective_radial_stress_kPa'") &&
          Catch::Contains("is 50:"));
  CHECK_THAT(found[1].text, Catch::Contains("η p′"));
}

TEST_CASE("ColumnConsistency: each pair of columns that say the same is compared") {
  const auto pair = GENERATE(table<std::string, std::string, std::string>({
      {"axial_strain,deviator_stress_kPa,axial_stress_kPa,radial_stress_kPa,pore_pressure_kPa",
       "0,50.0,450.0,400.0,300.0", "0,51.0,450.0,400.0,300.0"},
      {"axial_strain,deviator_stress_kPa,axial_stress_kPa,cell_pressure_kPa,pore_pressure_kPa",
       "0,50.0,450.0,400.0,300.0", "0,51.0,450.0,400.0,300.0"},
      {"axial_strain,deviator_stress_kPa,mean_effective_stress_kPa,stress_ratio",
       "0,50.0,100.0,0.500", "0,50.0,100.0,0.520"},
      {"axial_strain,effective_axial_stress_kPa,effective_radial_stress_kPa,"
       "mean_effective_stress_kPa",
       "0,150.0,100.0,116.7", "0,150.0,100.0,117.7"},
      {"axial_strain,deviator_stress_kPa,effective_radial_stress_kPa,mean_effective_stress_kPa",
       "0,50.0,100.0,116.7", "0,50.0,100.0,117.7"},
      {"axial_strain,deviator_stress_kPa,effective_axial_stress_kPa,mean_effective_stress_kPa",
       "0,50.0,150.0,116.7", "0,50.0,150.0,117.7"},
      {"axial_strain,effective_axial_stress_kPa,effective_radial_stress_kPa,axial_stress_kPa,"
       "pore_pressure_kPa",
       "0,150.0,100.0,450.0,300.0", "0,150.0,100.0,450.0,301.0"},
      {"axial_strain,effective_axial_stress_kPa,effective_radial_stress_kPa,radial_stress_kPa,"
       "pore_pressure_kPa",
       "0,150.0,100.0,400.0,300.0", "0,150.0,100.0,400.0,301.0"},
      {"axial_strain,effective_axial_stress_kPa,effective_radial_stress_kPa,cell_pressure_kPa,"
       "pore_pressure_kPa",
       "0,150.0,100.0,400.0,300.0", "0,150.0,100.0,400.0,301.0"},
      {"axial_strain,deviator_stress_kPa,mean_effective_stress_kPa,radial_stress_kPa,"
       "cell_pressure_kPa",
       "0,50.0,100.0,400.0,400.0", "0,50.0,100.0,400.0,401.0"},
      {"axial_strain (%),deviator_stress_kPa,mean_effective_stress_kPa,volumetric_strain (%),"
       "radial_strain (%)",
       "1.00,50.0,100.0,0.00,-0.50", "1.00,50.0,100.0,0.10,-0.50"},
      {"axial_strain (%),deviator_stress_kPa,mean_effective_stress_kPa,volumetric_strain (%),"
       "shear_strain (%)",
       "1.00,50.0,100.0,0.30,0.90", "1.00,50.0,100.0,0.30,0.95"},
      {"axial_strain (%),deviator_stress_kPa,mean_effective_stress_kPa,radial_strain (%),"
       "shear_strain (%)",
       "1.00,50.0,100.0,-0.50,1.00", "1.00,50.0,100.0,-0.50,1.05"},
      {"axial_strain (%),deviator_stress_kPa,mean_effective_stress_kPa,volumetric_strain (%),"
       "void_ratio",
       "0.00,0.0,100.0,0.00,0.8000", "1.00,50.0,100.0,1.00,0.8180"},
      {"axial_strain (%),deviator_stress_kPa,mean_effective_stress_kPa,pore_pressure_kPa,"
       "excess_pore_pressure_kPa",
       "0.00,0.0,100.0,300.0,0.0", "1.00,50.0,80.0,320.0,30.0"},
  }));
  INFO(std::get<0>(pair));
  CHECK(in_second_row(std::get<0>(pair), std::get<1>(pair), std::get<1>(pair)).empty());
  const auto found = in_second_row(std::get<0>(pair), std::get<1>(pair), std::get<2>(pair));
  REQUIRE(found.size() == 1);
  CHECK(found[0].line == 3);
}

TEST_CASE("ColumnConsistency: columns rounded to any digits never contradict") {
  std::string rows;

  for (int digits = 0; digits < 7; ++digits)
    for (int i = 1; i < 400; ++i) {
      const double axial = 100 + 0.37 * i, radial = 100 - 0.2431 * i;
      const double q = axial - radial, p = (axial + 2 * radial) / 3;
      rows += fmt::format("{1:.{0}f},{2:.{0}f},{3:.{0}f},{4:.{0}f},{5:.{0}f},{6:.{0}f}\n", digits,
                          0.013 * i, q, p, axial, radial, q / p);
    }
  CHECK(contradictions(kStresses + "\n" + rows).empty());
}

TEST_CASE("ColumnConsistency: finite and small strains both pass") {
  const std::string headings =
      "axial_strain,deviator_stress_kPa,mean_effective_stress_kPa,volumetric_strain,radial_strain,"
      "shear_strain";
  const double axial = 0.2, radial = -0.07;
  for (const double volume : {axial + 2 * radial, 1 - (1 - axial) * (1 - radial) * (1 - radial)})
    CHECK(in_second_row(headings, "0,0,100,0,0,0",
                        fmt::format("{:.6f},50,100,{:.6f},{:.6f},{:.6f}", axial, volume, radial,
                                    axial - volume / 3))
              .empty());
}

TEST_CASE("ColumnConsistency: a volume or pore pressure set to zero begins again") {
  const std::string volumes =
      "axial_strain (%),deviator_stress_kPa,mean_effective_stress_kPa,volumetric_strain (%),"
      "void_ratio\n";
  CHECK(contradictions(volumes + "0,0,50,0.00,0.8000\n0,0,100,1.00,0.7820\n0,0,100,0.00,0.7820\n"
                                 "0,9,100,1.00,0.7642\n")
            .empty());
  const std::string pressures =
      "axial_strain (%),deviator_stress_kPa,mean_effective_stress_kPa,pore_pressure_kPa,"
      "excess_pore_pressure_kPa\n";
  CHECK(contradictions(pressures + "0,0,50,100.0,0.0\n0,0,100,300.0,0.0\n1,9,95,310.0,10.0\n")
            .empty());
}

TEST_CASE("ColumnConsistency: missing cells contradict nothing") {
  CHECK(contradictions("q,delta_u,p_prime,epsilon_a\n0,0,100,0\n10,NaN,95,0.1\n").empty());
  CHECK(in_second_row(kStresses, "0,0,100.0,100.0,100.0,0", "1,,90.0,123.3,73.3,0.556").empty());
}

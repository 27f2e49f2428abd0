// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference_text.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "src/output/table.hpp"
#include "src/reference/reference_words.hpp"

using namespace triax;

namespace {

lab::AgsResults file_with(std::size_t tests) {
  lab::AgsResults file;
  file.file = "x.ags";
  for (std::size_t i = 0; i < tests; ++i) {
    lab::ReferenceResult& r = file.results.emplace_back();
    r.group = "TRET";
    r.specimen = {"BH102-A-2017", "22", "U", "", "B1[1]", 4.55, 4.68};
    r.test_type = "CIUCM";
    r.stage = std::to_string(i + 1);
    r.failure_mode = "Plastic with a single shear plane at the top";
    r.cell_pressure_pa = 1500e3;
    r.pore_pressure_pa = 1302.5e3;
    r.q_pa = 1321e3;
    r.axial_strain = 0.1125;
    r.volumetric_strain = -0.0121;
    r.undrained_strength_pa = 660.5e3;
    r.bulk_density_kg_m3 = 1650;
    r.cohesion_pa = 4e3;
  }
  return file;
}

}  // namespace

TEST_CASE("the text says what the file is, in lines that fit the terminal") {
  lab::AgsResults file = file_with(12);
  file.warnings = {{4, "something \x1b[31m assumed"}};
  const std::string text = src::reference_text(file, "t.db", 80);
  CHECK(text.find("x.ags: AGS4 results without readings, nothing to assess; 12 triaxial results") ==
        0);
  CHECK(text.find("reference values in t.db\n") != std::string::npos);
  CHECK(text.find("1302.5") != std::string::npos);
  CHECK(text.find("\x1b") == std::string::npos);
  CHECK(text.find("Note: line 4: something") != std::string::npos);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(src::display_width(line) <= 80);
  }
}

TEST_CASE("columns and tables of which nothing is known are left out") {
  lab::AgsResults file = file_with(1);
  lab::ReferenceResult& r = file.results[0];
  r.bulk_density_kg_m3 = r.cohesion_pa = r.volumetric_strain = std::nullopt;
  const std::string text = src::reference_text(file, "t.db", 100);
  CHECK(text.find("ε_v") == std::string::npos);
  CHECK(text.find("ε₁") != std::string::npos);
  CHECK(text.find("Specimens and strength") == std::string::npos);
  CHECK(text.find("Note") == std::string::npos);
}

TEST_CASE("a sample and a specimen in words") {
  CHECK(src::sample_of({"BH1", "22", "U", "id", "1", 4.55, std::nullopt}) == "22 U, 4.55 m");
  CHECK(src::sample_of({"BH1", "", "", "id", "1", std::nullopt, std::nullopt}) == "id");
  CHECK(src::specimen_of({"BH1", "", "", "", "", std::nullopt, std::nullopt}).empty());
  CHECK(src::specimen_of({"BH1", "", "", "", "B1[1]", std::nullopt, 4.68}) == "B1[1], 4.68 m");
}

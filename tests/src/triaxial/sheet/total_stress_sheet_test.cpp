// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/total_stress_sheet.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "src/triaxial/json_report.hpp"
#include "src/triaxial/sheet/corrections_box.hpp"
#include "src/triaxial/sheet/set_sheet.hpp"
#include "src/triaxial/sheet/sheet_json.hpp"
#include "src/triaxial/sheet/test_sheet.hpp"
#include "tests/src/sample_sheets.hpp"
#include "tests/src/triaxial/sheet/box_value.hpp"

using namespace triax;
using namespace triax::src;
using triax::src::test::value;

namespace {

/// q rises to `strength` · 2 at ε₁ = 10 % and falls; 1 %/min; nothing is known of u.
study::TestResult unconsolidated(double cell, double strength, const std::string& name = "UU 1") {
  study::TestResult test;
  auto& header = test.stored.header;
  header.name = name;
  header.programme = "UU";
  header.specimen = {.height_m = 0.076, .diameter_m = 0.038, .specific_gravity = 2.7};
  header.columns = {lab::Quantity::axial_displacement, lab::Quantity::axial_force,
                    lab::Quantity::cell_pressure};
  test.stored.summary.membrane_correction = "none";
  test.stored.id = static_cast<std::int64_t>(cell);
  for (int i = 0; i <= 150; ++i) {
    lab::State s;
    s.reading = i;
    s.strain = {1e-3 * i, -5e-4 * i};
    s.volumetric_strain = 0;
    s.time_s = 6.0 * i;
    s.q = strength * 2 * (1 - 1e-4 * (i - 100) * (i - 100));
    s.area_m2 = 1.134e-3 / (1 - s.strain.axial);
    test.curves.states.push_back(s);
  }
  return test;
}

SheetTest sheet_of_cell(double cell, double strength, const SheetRequest& request = {},
                        const std::string& name = "UU 1") {
  SheetTest test{unconsolidated(cell, strength, name), {}, {}};
  test.words = study::sheet_words(test.result.stored, request.said);
  study::SheetReader reader(test.result.stored, request.options);
  lab::Reading reading;
  reading.si.fill(lab::kMissing);
  reading[lab::Quantity::cell_pressure] = cell;
  for (const auto& s : test.result.curves.states) {
    reading.number = s.reading;
    reading.time_s = s.time_s;
    reader.add(reading, s);
  }
  test.values = reader.take();
  return test;
}

std::vector<std::string> titles(const Sheet& sheet) {
  std::vector<std::string> found;
  for (const auto& row : sheet.rows)
    for (const auto& part : row.parts)
      if (!part.plot) found.push_back(part.box.title);
  return found;
}

const SheetBox& box_titled(const Sheet& sheet, const std::string& title) {
  for (const auto& row : sheet.rows)
    for (const auto& part : row.parts)
      if (!part.plot && part.box.title == title) return part.box;
  throw std::runtime_error("no box " + title);
}

}  // namespace

TEST_CASE("the sheet of a UU test says c_u, total stresses and %/min, and no B") {
  SheetRequest request;
  request.said = {study::said_word("mass_g", "170"), study::said_word("water_content_pct", "24")};
  const auto test = sheet_of_cell(200e3, 50e3, request);
  const auto sheet = test_sheet(test);
  CHECK(sheet.title == "Unconsolidated undrained triaxial test");
  auto unconfined = test;
  unconfined.result.stored.header.programme = "UC";
  CHECK(test_sheet(unconfined).title == "Unconfined compression test");
  const auto boxes = titles(sheet);
  for (const char* none : {"Saturation", "Consolidation and rate", "Collapse"})
    CHECK(std::ranges::find(boxes, none) == boxes.end());
  const auto failure = total_stress_failure_box(test);
  CHECK(value(failure, "c_u = q_f/2 (kPa)") == "50.0");
  CHECK(value(failure, "q_f (kPa)") == "100.0");
  CHECK(value(failure, "σ₃ (kPa)") == "200.0");
  CHECK(value(failure, "σ₁ (kPa)") == "300.0");
  CHECK(value(failure, "ε_f (%)") == "10.00");
  const auto run = total_stress_test_box(test);
  CHECK(value(run, "rate of ε₁ up to failure (%/min)") == "1.000");
  CHECK(value(run, "rate (mm/min)") == "0.760");
  CHECK(value(run, "time to failure (min)") == "10.0");
  const auto specimen = total_stress_specimen_box(test);
  const double volume = 0.785398163 * 0.038 * 0.038 * 0.076;
  for (const auto& row : specimen.table.rows) {
    if (row[0] == "ρ (Mg/m³)") CHECK(row[1] == fmt::format("{:.3f}", 170e-6 / volume));
    if (row[0] == "ρ_d (Mg/m³)") CHECK(row[1] == fmt::format("{:.3f}", 170e-6 / 1.24 / volume));
    if (row[0] == "w (%)") CHECK(row[1] == "24.0");
  }
  CHECK(std::ranges::find(boxes, "Deviations from ISO 17892-8, ASTM D2850") != boxes.end());
}

TEST_CASE("a set of UU tests has circles of total stress and the mean c_u, apart from others") {
  std::vector<SheetTest> tests;
  tests.push_back(sheet_of_cell(100e3, 48e3, {}, "UU 1"));
  tests.push_back(sheet_of_cell(200e3, 50e3, {}, "UU 2"));
  tests.push_back(sheet_of_cell(400e3, 55e3, {}, "UU 3"));
  tests.push_back(test::sheet_of(test::flow_test()));
  tests.back().result.stored.id = 77;
  const auto sets = test_sets(tests);
  REQUIRE(sets.size() == 1);  // of the other there is only one
  REQUIRE(sets.front().tests.size() == 3);
  const auto sheet = set_sheet(sets.front());
  CHECK(sheet.title == "Set of 3 unconsolidated undrained triaxial tests");
  const auto& strength = box_titled(sheet, "Undrained strength of the set");
  CHECK(value(strength, "mean c_u (kPa)") == "51.0");
  CHECK(value(strength, "least, largest (kPa)") == "48.0, 55.0");
  CHECK(value(strength, "standard deviation (kPa)") == "3.6");
  bool has_phi = false;
  for (const auto& title : titles(sheet)) has_phi |= title.starts_with("Strength of the set");
  CHECK_FALSE(has_phi);
}

TEST_CASE("JSON says what the sheet says: c_u, side drains, piston, and that none is taken off") {
  SheetRequest request;
  request.said = {study::said_word("side_drains", "yes"),
                  study::said_word("piston_friction_N", "2")};
  auto test = sheet_of_cell(200e3, 50e3, request);
  test.result.stored.summary.consolidation.diameter_m = 0.038;
  const auto json = sheet_json(test);
  CHECK(json["failure"]["undrained_strength_kPa"].get<double>() == Approx(50));
  const auto& corrections = json["corrections"];
  CHECK(corrections["taken_off"] == false);
  CHECK(corrections["side_drains_kPa"].get<double>() == Approx(10));
  const double friction = 2e-3 / (1.134e-3 / 0.9);
  CHECK(corrections["piston_kPa"].get<double>() == Approx(friction));
  CHECK(corrections["q_without_them_kPa"].get<double>() == Approx(90 - friction));
  const auto box = corrections_box(test);
  CHECK(value(box, "side drains").find("Table 2: Δq = 10.00 kPa") != std::string::npos);
  CHECK(value(box, "piston").find(fmt::format("{:.2f} kPa", friction)) != std::string::npos);
  CHECK(value(box, "q_f without them")
            .starts_with(fmt::format("100.0 − {:.2f} = {:.1f} kPa", 10 + friction, 90 - friction)));
  auto plain = study::Json::parse(json_of_test(test.result));
  CHECK_FALSE(plain.contains("sheet"));
  CHECK(plain["undrained_strength"].is_null());
  test.result.stored.summary.undrained_strength = {.at = {100, 600.0, 0.1, 100e3, {}, {}},
                                                   .at_15_pct = {},
                                                   .last_axial_strain = 0.15,
                                                   .peaked = true};
  test.result.stored.header.specimen.cohesion_pa = 5e3;
  plain = study::Json::parse(json_of_test(test.result));
  CHECK(plain["undrained_strength"]["c_u_kPa"].get<double>() == Approx(50));
  CHECK(plain["undrained_strength"]["axial_strain"].get<double>() == Approx(0.1));
  CHECK(plain["undrained_strength"]["at_15_pct"].is_null());
  CHECK(plain["specimen"]["cohesion_kPa"].get<double>() == Approx(5));
}

TEST_CASE("a membrane that nobody took off is told with its size") {
  auto test = sheet_of_cell(200e3, 50e3);
  auto& specimen = test.result.stored.header.specimen;
  specimen.membrane_modulus_pa = 1400e3;
  specimen.membrane_thickness_m = 0.3e-3;
  test.result.stored.summary.consolidation.diameter_m = 0.038;
  const auto words = value(corrections_box(test), "membrane");
  CHECK(words.starts_with("none applied"));
  CHECK(words.find(fmt::format("= {:.2f} kPa", 4 * 1400 * 0.3 / 38 * 0.1)) != std::string::npos);
}

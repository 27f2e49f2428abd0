// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/load_corrections.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "lab/base/bad_input.hpp"
#include "src/study/sheet/deviations.hpp"
#include "tests/src/sample_sheets.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

namespace {

/// Failure at ε₁ = 0.5 %, q = 60 kPa; a raw record of a specimen of 70 mm.
TestResult raw_test() {
  auto test = sample::flow_test();
  test.stored.header.columns = {lab::Quantity::axial_displacement, lab::Quantity::axial_force,
                                lab::Quantity::cell_pressure, lab::Quantity::pore_pressure};
  test.stored.summary.consolidation.diameter_m = 0.07;
  for (auto& s : test.curves.states) s.area_m2 = 4e-3;
  return test;
}

src::SheetTest sheet_with(const std::vector<std::pair<std::string, std::string>>& said,
                          TestResult test = raw_test()) {
  src::SheetRequest request;
  for (const auto& [key, value] : said) request.said.push_back(said_word(key, value));
  return sample::sheet_of(std::move(test), request);
}

LoadCorrections corrections_with(const std::vector<std::pair<std::string, std::string>>& said,
                                 TestResult test = raw_test()) {
  const auto sheet = sheet_with(said, std::move(test));
  return load_corrections(sheet.result.stored, sheet.values, sheet.words);
}

}  // namespace

TEST_CASE("strips carry K_fp P_fp/A_c from 2 % on, below in proportion, nothing in extension") {
  const double d = 0.05, k = 190, area = std::numbers::pi / 4 * d * d;
  const double perimeter = 0.5 * std::numbers::pi * d;
  CHECK(side_drain_stress(k, 0.5, d, 0.02) == Approx(k * perimeter / area));
  CHECK(side_drain_stress(k, 0.5, d, 0.2) == Approx(k * perimeter / area));
  CHECK(side_drain_stress(k, 0.5, d, 0.005) == Approx(k * perimeter / area / 4));
  CHECK(side_drain_stress(k, 0.25, d, 0.02) == Approx(k * perimeter / area / 2));
  CHECK(side_drain_stress(k, 0.5, d, -0.02) == 0);
}

TEST_CASE("the table of BS 1377-8, and that it is the formula with 0.19 kN/m") {
  for (const auto& [mm, kPa] :
       {std::pair(38, 10.0), {50, 7.0}, {70, 5.0}, {100, 3.5}, {150, 2.5}}) {
    CHECK(side_drain_stress(mm * 1e-3, 0.05) == Approx(kPa * 1e3));
    CHECK(side_drain_stress(mm * 1e-3, 0.01) == Approx(kPa * 1e3 / 2));
    CHECK(side_drain_stress(190, 0.5, mm * 1e-3, 0.05) == Approx(kPa * 1e3).epsilon(0.1));
  }
  CHECK(side_drain_stress(0.06, 0.05) == Approx(6e3));
  CHECK(side_drain_stress(0.02, 0.05) == Approx(10e3));
  CHECK(side_drain_stress(0.3, 0.05) == Approx(2.5e3));
}

TEST_CASE("side drains as they are said") {
  CHECK_FALSE(corrections_with({}).side_drains);
  CHECK_FALSE(corrections_with({{"side_drains", "no"}}).side_drains);
  CHECK_FALSE(corrections_with({{"side_drains", "spiral"}}).side_drains);
  const auto table = corrections_with({{"drained_at", "sides and both ends"}});
  REQUIRE(table.side_drains);
  CHECK(table.side_drains->taken_off_pa == Approx(5e3 / 4));
  const auto formula = corrections_with(
      {{"side_drains", "yes"}, {"drain_load_kN_m", "0,21"}, {"drain_cover_pct", "40"}});
  REQUIRE(formula.side_drains);
  CHECK(formula.side_drains->taken_off_pa == Approx(210 * 0.4 * 4 / 0.07 / 4));
  auto reduced = raw_test();
  reduced.stored.header.columns.clear();
  CHECK_FALSE(corrections_with({{"side_drains", "yes"}}, reduced).side_drains);
}

TEST_CASE("the piston: friction, uplift of the change of cell pressure, weight") {
  CHECK_FALSE(corrections_with({}).piston);
  const auto friction = corrections_with({{"piston_friction_N", "2"}});
  REQUIRE(friction.piston);
  CHECK(friction.piston->taken_off_pa == Approx(2 / 4e-3));
  const auto without = corrections_with({{"load_cell", "outside"}});
  CHECK_FALSE(without.piston);
  CHECK(without.why_no_piston.find("piston_diameter_mm") != std::string::npos);
  const auto sheet = sheet_with({{"load_cell", "outside"},
                                 {"piston_diameter_mm", "20"},
                                 {"piston_mass_g", "500"},
                                 {"piston_friction_N", "1.5"},
                                 {"load_zero_kPa", "0"}});
  const auto whole = load_corrections(sheet.result.stored, sheet.values, sheet.words);
  REQUIRE(whole.piston);
  const double cell = sheet.values.failure->cell_pressure;
  CHECK(cell > 100e3);
  const double expected = (1.5 + std::numbers::pi * 1e-4 * cell - 0.5 * 9.81) / 4e-3;
  CHECK(whole.piston->taken_off_pa == Approx(expected));
  CHECK(*whole.q_left_pa(sheet.values) == Approx(60e3 - expected));
}

TEST_CASE("a correction that is large and not taken off is a deviation") {
  const auto any_says = [](const src::SheetTest& sheet, const std::string& part) {
    return std::ranges::any_of(deviations_of(sheet.result.stored, sheet.values, sheet.words),
                               [&](const auto& s) { return s.find(part) != std::string::npos; });
  };
  CHECK(any_says(sheet_with({{"side_drains", "yes"}, {"drain_load_kN_m", "2"}}),
                 "side drains carry"));
  CHECK_FALSE(any_says(sheet_with({{"side_drains", "yes"}}), "side drains carry"));
  CHECK(any_says(sheet_with({{"piston_friction_N", "2"}}), "the piston makes 0.8 % of q_f"));
}

TEST_CASE("values that no apparatus has are refused") {
  for (const auto& [key, value] :
       std::vector<std::pair<std::string, std::string>>{{"drain_cover_pct", "60"},
                                                        {"drain_load_kN_m", "much"},
                                                        {"piston_friction_N", "-1"},
                                                        {"load_cell", "beside"},
                                                        {"side_drains", "perhaps"}}) {
    INFO(key);
    CHECK_THROWS_AS(said_word(key, value), lab::BadInput);
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/test_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/triaxial/json_report.hpp"
#include "src/triaxial/sheet/set_sheet.hpp"
#include "src/triaxial/sheet/sheet_boxes.hpp"
#include "tests/src/sample_sheets.hpp"
#include "tests/src/triaxial/sheet/box_value.hpp"

using namespace triax;
using namespace triax::src;
using study::TestResult;
using triax::src::test::value;

namespace {

std::string cell(const SheetBox& box, const std::string& row, std::size_t column) {
  for (const auto& cells : box.table.rows)
    if (cells.front() == row) return cells.at(column);
  return "no " + row;
}

/// Three drained tests that fail on c′ = 12 kPa, φ′ = 30°.
std::vector<TestResult> worked_set() {
  std::vector<TestResult> tests;
  for (const double minor : {50e3, 100e3, 200e3}) {
    auto test = test::flow_test();
    const double k = 3;  // (1 + sin 30°)/(1 − sin 30°)
    const double major = 2 * 12e3 * std::sqrt(k) + k * minor;
    test.curves.states.resize(301);
    for (auto& s : test.curves.states) {
      const double share = static_cast<double>(s.reading) / 300;
      s.q = share * (major - minor);
      s.p_eff = minor + s.q / 3;
      s.effective_stress = {minor + s.q, minor};
    }
    test.stored.id = 10 + static_cast<std::int64_t>(tests.size());
    test.stored.header.name = fmt::format("set {}", tests.size());
    test.stored.header.digest.clear();
    test.stored.summary.peak.reset();
    test.stored.summary.collapse = {};
    tests.push_back(std::move(test));
  }
  return tests;
}

}  // namespace

TEST_CASE("the sheet says what the JSON report says") {
  const auto sheet = test::sheet_of(test::flow_test());
  const auto json = nlohmann::json::parse(json_of_test(sheet.result));
  const auto number = [](const nlohmann::json& value, const char* form) {
    return fmt::format(fmt::runtime(form), value.get<double>());
  };
  const auto failure = failure_box(sheet);
  const auto& peak = json["peak"];
  CHECK(value(failure, "q_f (kPa)") == number(peak["q_kPa"], "{:.1f}"));
  CHECK(value(failure, "p′ (kPa)") == number(peak["p_eff_kPa"], "{:.1f}"));
  CHECK(value(failure, "u (kPa)") == number(peak["pore_pressure_kPa"], "{:.1f}"));
  CHECK(value(failure, "η = q/p′") == number(peak["eta"], "{:.3f}"));
  CHECK(value(failure, "ε₁ (%)") ==
        fmt::format("{:.2f}", peak["axial_strain"].get<double>() * 100));
  CHECK(value(failure, "reading") == fmt::format("{}", peak["reading"].get<int>()));
  CHECK(value(saturation_box(sheet), "B = Δu/Δσ_c") ==
        number(json["consolidation"]["b_value"], "{:.3f}"));
  CHECK(value(consolidation_box(sheet), "p′₀ (kPa)") ==
        number(json["consolidation"]["p_eff_kPa"], "{:.1f}"));
  const auto specimen = specimen_box(sheet);
  CHECK(cell(specimen, "H (mm)", 1) == number(json["specimen"]["height_mm"], "{:.2f}"));
  CHECK(cell(specimen, "D (mm)", 1) == number(json["specimen"]["diameter_mm"], "{:.2f}"));
  CHECK(cell(specimen, "e", 1) == number(json["specimen"]["void_ratio"], "{:.3f}"));
  CHECK(cell(specimen, "e", 2) == number(json["consolidation"]["void_ratio"], "{:.3f}"));
  const auto collapse = verdict_box(sheet);
  CHECK(collapse.marked == json["collapse"]["detected"].get<bool>());
  CHECK(value(collapse, "result").starts_with(json["collapse"]["kind"].get<std::string>()));
  CHECK(value(collapse, "onset of instability")
            .find("η " + number(json["collapse"]["eta"], "{:.2f}")) != std::string::npos);
}

TEST_CASE("verdict_box: the loss of control has its own row", "[sheet]") {
  auto test = test::flow_test();
  const auto has_row = [&](const SheetBox& box) {
    return std::ranges::any_of(box.facts,
                               [](const Fact& fact) { return fact.label == "loss of control"; });
  };
  CHECK_FALSE(has_row(verdict_box(test::sheet_of(test))));
  auto& collapse = test.stored.summary.collapse;
  collapse.loss_of_control = lab::Instant{340, 34.0, 0.006, 50e3, 80e3, 380e3};
  collapse.loss_of_control->interval = {{49e3, 51e3}, {78e3, 82e3}, {0.6, 0.65}};
  const auto box = verdict_box(test::sheet_of(test));
  REQUIRE(has_row(box));
  const auto row = std::ranges::find(box.facts, "loss of control", &Fact::label);
  REQUIRE(row->lines.size() == 2);
  CHECK(row->lines[0].find("340") != std::string::npos);
  CHECK(row->lines[1] == "η 0.600 to 0.650 with 95 %; detected only when the record had ended");
}

TEST_CASE("what nobody says is a blank, what is simulated is marked") {
  const auto recorded = test_sheet(test::sheet_of(test::flow_test()));
  CHECK(recorded.mark.empty());
  CHECK(value(recorded.rows.front().parts.front().box, "Borehole").empty());
  CHECK(test_sheet(test::sheet_of(test::simulated_test())).mark == "SIMULATED");
  CHECK(test_sheet(test::sheet_of(test::interrupted_test())).mark == "INTERRUPTED");
}

TEST_CASE("a worked set of circles gives back its c' and phi'") {
  auto sheets = test::sheets_of(worked_set());
  const auto sets = test_sets(sheets.tests);
  REQUIRE(sets.size() == 1);
  const auto sheet = set_sheet(sets.front());
  const SheetBox* strength = nullptr;
  for (const auto& row : sheet.rows)
    for (const auto& part : row.parts)
      if (part.box.title.starts_with("Strength")) strength = &part.box;
  REQUIRE(strength != nullptr);
  CHECK(value(*strength, "c′ (kPa)").starts_with("12.0 ("));
  CHECK(value(*strength, "φ′ (°)").starts_with("30.0 ("));
}

TEST_CASE("tests of several soils are several sets, a file counts once, one test is no set") {
  auto tests = worked_set();
  tests[0].stored.header.specimen.material = "A";
  tests[1].stored.header.specimen.material = "B";
  tests[2].stored.header.specimen.material = "B";
  CHECK(test_sets(test::sheets_of(tests).tests).size() == 1);
  tests[1].stored.header.digest = tests[2].stored.header.digest = "abc";
  auto again = test::sheets_of(tests);
  CHECK(test_sets(again.tests).empty());

  // Of two readings of a file the later complete one counts, as in all statistics.
  tests = worked_set();
  tests[1].stored.header.digest = tests[2].stored.header.digest = "abc";
  tests[2].stored.status = db::TestStatus::interrupted;
  again = test::sheets_of(tests);
  const auto sets = test_sets(again.tests);
  REQUIRE(sets.size() == 1);
  CHECK(sets.front().read_again == 1);
  REQUIRE(sets.front().tests.size() == 2);
  CHECK(sets.front().tests.back()->result.stored.id == tests[1].stored.id);
}

TEST_CASE("of many tests the set tells the spread") {
  std::vector<TestResult> many;
  for (int i = 0; i < 40; ++i) {
    auto test = worked_set()[static_cast<std::size_t>(i % 3)];
    test.stored.id = i;
    many.push_back(std::move(test));
  }
  const auto sheets = test::sheets_of(std::move(many));
  CHECK_FALSE(sheets.has_page_of_each());
  const auto sheet = set_sheet(test_sets(sheets.tests).front());
  CHECK(sheet.rows[1].parts.front().box.table.columns[4].heading == "median");
  CHECK(sheet.rows[1].parts.front().box.table.rows.size() < 12);
}

TEST_CASE("the title names constant shear and strain paths by what they are") {
  auto test = test::flow_test();
  test.stored.header.programme = "CSD";  // its weights hang on the ram: load control
  test.stored.header.stages.front().control = lab::AxialControl::load;
  test.stored.header.stages.front().drainage = lab::Drainage::open;
  CHECK(kind_of_test(test::sheet_of(test)) == "Constant-shear drained test");
  test.stored.header.stages.front().strain_path_R = 0.7;
  CHECK(kind_of_test(test::sheet_of(test)) == "Strain-path triaxial test, R = 0.7");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/total_stress.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "src/study/sheet/deviations.hpp"
#include "tests/src/sample_sheets.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

namespace {

constexpr double kRate = 0.01 / 60;  // 1/s: 1 %/min

/// q = q(ε₁) to the last strain, by steps of 0.1 %, nothing known of u.
template <class Q>
TestResult unconsolidated(const Q& q, double last_strain) {
  TestResult test;
  auto& stored = test.stored;
  stored.header.programme = "uu";
  stored.header.specimen.height_m = 0.076;
  stored.header.specimen.diameter_m = 0.038;
  stored.header.columns = {lab::Quantity::axial_displacement, lab::Quantity::axial_force,
                           lab::Quantity::cell_pressure};
  stored.summary.membrane_correction = "astm";
  for (std::int64_t i = 0; 1e-3 * static_cast<double>(i) <= last_strain + 1e-9; ++i) {
    lab::State s;
    s.reading = i;
    s.strain.axial = 1e-3 * static_cast<double>(i);
    s.time_s = s.strain.axial / kRate;
    s.q = q(s.strain.axial);
    test.curves.states.push_back(s);
  }
  return test;
}

bool any_says(const src::SheetTest& sheet, const std::string& part) {
  return std::ranges::any_of(deviations_of(sheet.result.stored, sheet.values, sheet.words),
                             [&](const auto& s) { return s.find(part) != std::string::npos; });
}

double peaked(double strain) { return 100e3 * (1 - std::pow(strain / 0.08 - 1, 2)); }

}  // namespace

TEST_CASE("c_u is half of the largest q, and needs no pore pressure") {
  const auto sheet = sample::sheet_of(unconsolidated(peaked, 0.15));
  REQUIRE(sheet.values.failure);
  CHECK(sheet.values.failure->state.strain.axial == Approx(0.08));
  CHECK(*undrained_strength(sheet.values.failure) == Approx(50e3));
  CHECK(*sheet.values.rate_per_s == Approx(kRate));
  CHECK_FALSE(any_says(sheet, "%/min"));
  CHECK_FALSE(any_says(sheet, "B was not measured"));
  CHECK_FALSE(any_says(sheet, "t_100"));
}

TEST_CASE("a q that rises is taken at 20 %, and said to be taken at 15 % by D2850") {
  const auto rising = [](double strain) { return 500e3 * strain; };
  const auto sheet = sample::sheet_of(unconsolidated(rising, 0.25));
  REQUIRE(sheet.values.failure);
  CHECK(sheet.values.failure->state.strain.axial == Approx(0.20));
  CHECK(*undrained_strength(sheet.values.failure) == Approx(50e3));
  CHECK(sheet.values.failure_reason.find("20 %") != std::string::npos);
  CHECK(any_says(sheet, "the failure strain of ASTM D2850: c_u 37.5 kPa"));
  const auto short_one = sample::sheet_of(unconsolidated(rising, 0.10));
  CHECK(any_says(short_one, "q had not fallen when shear ended at 10.0 %"));
}

TEST_CASE("failure at a strain, and criteria that total stresses do not have") {
  src::SheetRequest request;
  request.options.failure = FailureCriterion::axial_strain;
  request.options.failure_strain = 0.04;
  const auto at = sample::sheet_of(unconsolidated(peaked, 0.15), request);
  CHECK(*undrained_strength(at.values.failure) == Approx(75e3 / 2));
  for (const auto criterion :
       {FailureCriterion::peak_stress_ratio, FailureCriterion::critical_state}) {
    request.options.failure = criterion;
    const auto none = sample::sheet_of(unconsolidated(peaked, 0.15), request);
    CHECK_FALSE(none.values.failure);
    CHECK(none.values.failure_reason.starts_with("not defined in total stresses"));
  }
}

TEST_CASE("in which way a test is no UU test of the standards") {
  auto result = unconsolidated(peaked, 0.15);
  result.stored.header.columns.push_back(lab::Quantity::pore_pressure);
  result.stored.header.stages = {
      {1, "", lab::StageRole::consolidation, lab::Drainage::open, lab::AxialControl::unknown},
      {2, "", lab::StageRole::shear, lab::Drainage::open, lab::AxialControl::displacement}};
  for (auto& s : result.curves.states) s.stage = 2;
  for (auto& s : result.curves.states) s.time_s /= 5;
  const auto sheet = sample::sheet_of(std::move(result));
  CHECK(any_says(sheet, "pore pressure was measured"));
  CHECK(any_says(sheet, "consolidation stage"));
  CHECK(any_says(sheet, "drainage open"));
  CHECK(any_says(sheet, "sheared at 5 %/min"));
}

TEST_CASE("the mean of a set") {
  const std::array c{48.0, 50.0, 55.0};
  const auto mean = mean_strength(c);
  CHECK(mean.mean == Approx(51));
  CHECK(mean.least == 48);
  CHECK(mean.largest == 55);
  CHECK(*mean.standard_deviation == Approx(std::sqrt((9.0 + 1 + 16) / 2)));
  CHECK_FALSE(mean_strength(std::array{4.0}).standard_deviation);
}

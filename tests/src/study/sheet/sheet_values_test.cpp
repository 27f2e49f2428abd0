// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/sheet_values.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tuple>

#include "lab/base/bad_input.hpp"
#include "src/study/sheet/deviations.hpp"
#include "src/study/sheet/specimen_phases.hpp"
#include "tests/src/contains.hpp"
#include "tests/src/sample_sheets.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;
using src::SheetRequest;
using src::SheetTest;

namespace {

SheetTest with(FailureCriterion criterion, double strain = 0.15) {
  SheetRequest request;
  request.options.failure = criterion;
  request.options.failure_strain = strain;
  return sample::sheet_of(sample::flow_test(), request);
}

bool any_sentence_says(const std::vector<std::string>& sentences, const std::string& part) {
  return std::ranges::any_of(sentences, [&](const auto& s) { return s.find(part) != s.npos; });
}

}  // namespace

TEST_CASE("failure is where the chosen criterion says") {
  const auto q = with(FailureCriterion::peak_deviator_stress);
  REQUIRE(q.values.failure);
  CHECK(q.values.failure->state.reading == 300);
  CHECK(q.values.failure->state.q == Approx(60e3));
  CHECK(*q.values.rate_per_s == Approx(0.005 / 30));
  const auto strain = with(FailureCriterion::axial_strain, 0.03);
  REQUIRE(strain.values.failure);
  CHECK(strain.values.failure->state.strain.axial == Approx(0.03).margin(3e-4));
  CHECK_FALSE(with(FailureCriterion::axial_strain, 0.4).values.failure);
  const auto ratio = with(FailureCriterion::peak_stress_ratio);
  REQUIRE(ratio.values.failure);
  for (const auto& s : ratio.result.curves.states)
    if (s.effective_stress.radial > 1e3)
      CHECK(s.effective_stress.axial / s.effective_stress.radial <=
            ratio.values.failure->state.effective_stress.axial /
                    ratio.values.failure->state.effective_stress.radial +
                1e-9);
}

TEST_CASE("what a dead sensor said is no failure") {
  auto test = sample::flow_test();
  test.stored.events.push_back({.reading = 200, .kind = lab::EventKind::sensor_fault});
  test.stored.summary.collapse.judged_until = 199;
  test.stored.summary.peak.reset();
  CHECK(last_believed_reading(test.stored) == 199);
  const auto sheet = sample::sheet_of(test);
  REQUIRE(sheet.values.end);
  CHECK(sheet.values.end->state.reading == 199);
  CHECK(sheet.values.failure->state.reading == 199);
  CHECK(any_sentence_says(deviations_of(sheet.result.stored, sheet.values, sheet.words),
                          "a sensor failed"));
}

TEST_CASE("a test at constant q, simulated, is told to be none of the standards' tests") {
  auto result = sample::simulated_test();
  result.stored.header.stages[0].control = lab::AxialControl::constant_q;
  const auto test = sample::sheet_of(result);
  const auto deviations = deviations_of(test.result.stored, test.values, test.words);
  CHECK(any_sentence_says(deviations, "CSU: shear at constant q is not a test of these standards"));
  CHECK(any_sentence_says(deviations, "simulated"));
  const auto plain = sample::sheet_of(sample::flow_test());
  CHECK_FALSE(any_sentence_says(deviations_of(plain.result.stored, plain.values, plain.words),
                                "constant q"));
}

TEST_CASE("masses, water and saturation follow from what is said") {
  auto result = sample::flow_test();
  result.stored.header.specimen.specific_gravity = 2.65;
  result.stored.header.specimen.void_ratio = 0.6;
  SheetRequest request;
  request.said = {said_word("mass_g", "1050,0"), said_word("L<oose> 1/borehole", "B3"),
                  said_word("drained_at", "both ends")};
  const auto test = sample::sheet_of(result, request);
  CHECK(word_of(test.words, "borehole") == "B3");
  CHECK(drained_at(test.words) == DrainageBoundary::both_ends);
  const auto built = specimen_phases(test.result.stored, test.values, test.words).built;
  const double dry = 2650 / 1.6, volume = 0.785398163 * 0.07 * 0.07 * 0.14;
  CHECK(*built.dry_density == Approx(dry));
  CHECK(*built.water_content == Approx(1.05 / (dry * volume) - 1));
  CHECK(*built.saturation == Approx(*built.water_content * 2.65 / 0.6));
  CHECK_THROWS_AS(said_word("colour", "red"), lab::BadInput);
  CHECK_THROWS_AS(said_word("drained_at", "nowhere"), lab::BadInput);
}

TEST_CASE("a preamble fills the head and says where the specimen drained") {
  auto result = sample::flow_test();
  result.stored.header.notes = {{"Borehole", "MB7"},
                                {"Depth", "2,55"},
                                {"Top Drain Used (y/n)", "y"},
                                {"Base Drain Used (y/n)", "n"},
                                {"Side Drains Used (y/n)", "y"}};
  const auto words = sheet_words(result.stored, {});
  CHECK(word_of(words, "borehole") == "MB7");
  CHECK(number_of(words, "depth") == Approx(2.55));
  CHECK(drained_at(words) == DrainageBoundary::sides_and_one_end);
  CHECK(word_of(words, "operator").empty());
}

TEST_CASE("labels of the sheets with Jefferies and Been's book fill the head") {
  auto result = sample::flow_test();
  result.stored.header.notes = {{"Lab", "A & B"},
                                {"Job number", "7"},
                                {"Test date", "1 FEB 89"},
                                {"Preparation method", "moist tamped"}};
  const auto words = sheet_words(result.stored, {});
  CHECK(word_of(words, "laboratory") == "A & B");
  CHECK(word_of(words, "project") == "7");
  CHECK(word_of(words, "date") == "1 FEB 89");
  CHECK(word_of(words, "specimen_type") == "moist tamped");
}

namespace {

constexpr double kUnit_s = 4000;  // H²/c_v

/// Water that leaves by Terzaghi's theory (drained at one end) to T = 4, then shear at an even
/// rate to ε₁ = 4 %, where q is largest.
SheetTest consolidated(lab::Drainage drainage, DrainageBoundary at) {
  TestResult result;
  auto& header = result.stored.header;
  header.specimen.height_m = 0.1;
  header.specimen.diameter_m = 0.05;
  header.stages = {{1, "", lab::StageRole::consolidation, lab::Drainage::open},
                   {2, "", lab::StageRole::shear, drainage, lab::AxialControl::displacement}};
  SheetRequest request;
  request.options.drained_at = at;
  SheetTest test{std::move(result), {}, {}};
  SheetReader reader(test.result.stored, request.options);
  lab::Reading reading;
  reading.si.fill(lab::kMissing);
  lab::State state;
  const auto add = [&](int stage, double time) {
    reading.number = state.reading = state.reading + 1;
    reading.stage = state.stage = stage;
    reading.time_s = state.time_s = time;
    reading[lab::Quantity::cell_pressure] = 500e3;
    reader.add(reading, state);
  };
  state.q = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double factor = 4.0 * i / 2000;
    double left = 0;
    for (int m = 0; m < 200; ++m) {
      const double root = std::numbers::pi / 2 * (2 * m + 1);
      left += 2 / (root * root) * std::exp(-root * root * factor);
    }
    reading[lab::Quantity::back_volume] = -10e-6 * (1 - left);
    state.pore_pressure = 300e3 + 100e3 * left;
    state.effective_stress = {200e3 - 100e3 * left, 200e3 - 100e3 * left};
    state.p_eff = state.effective_stress.axial;
    add(1, factor * kUnit_s);
  }
  for (int i = 0; i <= 100; ++i) {
    const double strain = 0.05 * i / 100;
    state.strain.axial = strain;
    state.q = 80e3 * (1 - std::pow(strain / 0.04 - 1, 2));
    state.effective_stress = {200e3 + state.q, 200e3};
    state.p_eff = 200e3 + state.q / 3;
    add(2, 4 * kUnit_s + 100.0 * i);
  }
  test.values = reader.take();
  return test;
}

}  // namespace

// t_100 = π/4 H²/c_v where the water leaves at one end; ε₁/t_f with t_f = F t_100, in closed form.
TEST_CASE("the rate that t_100 allows brings failure after F t_100") {
  const double t100 = std::numbers::pi / 4 * kUnit_s;
  for (const auto& [drainage, at, factor] :
       {std::tuple(lab::Drainage::open, DrainageBoundary::one_end, 8.5),
        {lab::Drainage::open, DrainageBoundary::sides_and_both_ends, 15.8},
        {lab::Drainage::closed, DrainageBoundary::one_end, 0.53},
        {lab::Drainage::closed, DrainageBoundary::both_ends, 2.1}}) {
    const auto test = consolidated(drainage, at);
    REQUIRE(test.values.allowed_rate_per_s);
    CHECK(test.values.failure->state.strain.axial == Approx(0.04));
    CHECK(*test.values.allowed_rate_per_s == Approx(0.04 / (factor * t100)).epsilon(0.01));
    CHECK(*test.values.rate_per_s == Approx(0.05 / 1e4));
  }
  // 0.05/1e4 per second is faster than 0.04/(8.5 t_100) by that ratio.
  const auto drained = consolidated(lab::Drainage::open, DrainageBoundary::one_end);
  CHECK(any_sentence_says(deviations_of(drained.result.stored, drained.values, drained.words),
                          "sheared 3.3 times as fast as t_100 allows"));
}

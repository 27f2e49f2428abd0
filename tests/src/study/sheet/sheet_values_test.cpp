// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/sheet_values.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
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

bool any_says(const std::vector<std::string>& sentences, const std::string& part) {
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
  CHECK(any_says(deviations_of(sheet.result.stored, sheet.values), "a sensor failed"));
}

TEST_CASE("a test at constant q, simulated, is told to be none of the standards' tests") {
  auto result = sample::simulated_test();
  result.stored.header.stages[0].control = lab::AxialControl::constant_q;
  const auto test = sample::sheet_of(result);
  const auto deviations = deviations_of(test.result.stored, test.values);
  CHECK(any_says(deviations, "CSU: shear at constant q is none of the standards' tests"));
  CHECK(any_says(deviations, "simulated"));
  const auto plain = sample::sheet_of(sample::flow_test());
  CHECK_FALSE(any_says(deviations_of(plain.result.stored, plain.values), "constant q"));
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/shear_series.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

TEST_CASE("a stage counts as shear where it is said, and where nothing is said of it") {
  lab::RecordHeader header;
  CHECK(is_shear(header, 1));
  header.stages = {{.number = 1, .name = "c", .role = lab::StageRole::consolidation},
                   {.number = 2, .name = "s", .role = lab::StageRole::shear},
                   {.number = 3, .name = "?", .role = lab::StageRole::unknown}};
  CHECK_FALSE(is_shear(header, 1));
  CHECK(is_shear(header, 2));
  CHECK(is_shear(header, 3));
}

TEST_CASE("the drainage of a shear is what its stages say, and what moved where they do not") {
  using lab::Drainage;
  lab::RecordHeader header;
  header.stages = {{.number = 1, .name = "?"},
                   {.number = 2, .name = "o", .drainage = Drainage::open},
                   {.number = 3, .name = "c", .drainage = Drainage::closed}};
  const auto shear = [](std::vector<std::pair<int, double>> of) {
    std::vector<lab::State> states(of.size());
    for (std::size_t i = 0; i < of.size(); ++i) {
      states[i].stage = of[i].first;
      states[i].volumetric_strain = of[i].second;
    }
    return states;
  };
  const auto of = [&](std::vector<std::pair<int, double>> states) {
    return drainage_of_shear(header, shear(std::move(states)));
  };
  CHECK(of({}) == Drainage::unknown);
  CHECK(of({{1, 0}, {3, 0.1}}) == Drainage::closed);
  CHECK(of({{2, 0}, {2, 0}}) == Drainage::open);
  CHECK(of({{2, 0}, {3, 0.02}}) == Drainage::open);
  CHECK(of({{1, 0}, {1, 0.0011}}) == Drainage::open);
  CHECK(of({{1, 0}, {1, -9e-4}}) == Drainage::closed);
  CHECK(of({{1, 0.03}, {1, 0.0301}}) == Drainage::closed);  // what consolidation left
  CHECK(of({{1, std::nan("")}, {1, std::nan("")}}) == Drainage::closed);
}

TEST_CASE("shear_series: the state at the loss of control is the nearest", "[study]") {
  auto test = sample::flow_test();
  CHECK_FALSE(shear_series({test}).tests[0].at_loss_of_control);
  test.stored.summary.collapse.loss_of_control = lab::Instant{.reading = 341};
  const auto series = shear_series({test});
  REQUIRE(series.tests[0].loss_of_control);
  REQUIRE(series.tests[0].at_loss_of_control);
  CHECK(series.tests[0].at_loss_of_control->reading == 341);
  CHECK_FALSE(nearest_state({}, lab::Instant{}));
  CHECK_FALSE(nearest_state(test.curves.states, std::nullopt));
}

TEST_CASE("a series leaves out other stages than shear") {
  auto test = sample::flow_test();
  test.stored.header.stages.push_back(
      {.number = 2, .name = "c", .role = lab::StageRole::consolidation});
  test.curves.states[7].stage = 2;
  const auto series = shear_series({test, sample::stable_test()});
  REQUIRE(series.tests.size() == 2);
  CHECK(series.tests[0].name == "L<oose> 1");
  CHECK(series.tests[0].states.size() == test.curves.states.size() - 1);
  CHECK(series.tests[0].states[7].reading == 8);
  CHECK(series.tests[1].states.size() == 501);
}

TEST_CASE("a series knows its onsets, its instability line, its limits and its origin") {
  const auto series =
      shear_series({sample::flow_test(), sample::simulated_test(), sample::stable_test()});
  CHECK(series.tests[0].onset->reading == 300);
  CHECK_FALSE(series.tests[2].onset);
  CHECK(series.strain_at_onset == 0.005);
  REQUIRE(series.instability_lines.size() == 1);
  CHECK(series.instability_lines[0] == Approx((60. * 100 + 110 * 200) / (100 * 100 + 200 * 200)));
  CHECK(series.limit_stress_ratios == std::vector<double>{1.25});
  CHECK(series.origin.tests == 3);
  CHECK(series.origin.simulated == std::vector<std::string>{"sim-26"});
  CHECK(shear_series({sample::stable_test()}).strain_at_onset == 0);
}

TEST_CASE("the state at the onset is the nearest that was kept") {
  auto test = sample::flow_test();
  CHECK(shear_series({test}).tests[0].at_onset->reading == 300);
  std::erase_if(test.curves.states, [](const auto& s) { return s.reading % 7 != 0; });
  CHECK(shear_series({test}).tests[0].at_onset->reading == 301);
  test.curves = {};
  CHECK_FALSE(shear_series({test}).tests[0].at_onset);
  CHECK_FALSE(shear_series({sample::stable_test()}).tests[0].at_onset);
}

TEST_CASE("the beginning of shear ends some strains behind the largest at an onset") {
  const auto [series, last_strain] = shear_beginnings({sample::flow_test(), sample::stable_test()});
  CHECK(last_strain == Approx(2.5 * 0.005));
  for (const auto& test : series.tests) {
    REQUIRE(test.states.size() > 10);
    CHECK(test.states.back().strain.axial <= last_strain);
    CHECK(test.states.back().strain.axial > 0.95 * last_strain);
  }
  CHECK(series.tests[0].at_onset->reading == 300);
}

TEST_CASE("without an onset, and where it comes late, the beginning is all of shear") {
  const auto stable = shear_beginnings({sample::stable_test()});
  CHECK(stable.last_strain == Approx(0.15));
  CHECK(stable.series.tests[0].states.size() == 501);
  auto late = sample::flow_test();
  late.stored.summary.collapse.onset->axial_strain = 0.09;
  const double largest = late.curves.states.back().strain.axial;
  CHECK(shear_beginnings({late}).last_strain == largest);
}

TEST_CASE("tests of one name are told apart by their numbers") {
  auto first = triax::src::test::flow_test(), second = triax::src::test::flow_test();
  second.stored.id = 9;
  const auto series = triax::study::shear_series({first, second});
  CHECK(series.tests[0].name == "L<oose> 1 (3)");
  CHECK(series.tests[1].name == "L<oose> 1 (9)");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/earlier_tests.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/lab/warning/loose_path.hpp"

using namespace triax::lab;
using triax::lab::testing::shear_header;
using Control = DrivenPath::Control;

namespace {

EarlierTest lost(double eta, double give = 0, Control control = Control::strain_path) {
  return {.name = "lost", .control = control, .give = give, .onset = eta, .onset_error = 0.001};
}

EarlierTest sound(double work) {
  return {.name = "sound", .control = Control::strain_path, .min_work = work};
}

TestSummary collapse_at(double eta, std::optional<double> b_value = {}) {
  TestSummary summary;
  summary.consolidation.b_value = b_value;
  summary.collapse.kind = CollapseKind::flow;
  summary.collapse.onset = Instant{.reading = 100, .q_pa = eta * 1e5, .p_eff_pa = 1e5};
  summary.collapse.onset->interval = StressInterval{.eta = {eta - 0.022, eta + 0.022}};
  return summary;
}

Forecast forecast(std::int64_t reading, double eta, double left) {
  return {.reading = reading,
          .eta = eta,
          .eta_low = eta - 0.01645,
          .eta_high = eta + 0.01645,
          .left = LeftToOnset{.value = left}};
}

}  // namespace

TEST_CASE("earlier tests agree by their precisions, and an error is not below their scatter") {
  EarlierTests tests;
  CHECK_FALSE(tests.onset(Control::strain_path, false, 0));
  tests.add(lost(0.60));
  const auto one = tests.onset(Control::strain_path, false, 0);
  REQUIRE(one);
  CHECK(one->eta == Approx(0.60));
  tests.add(lost(0.61));
  const auto two = tests.onset(Control::strain_path, false, 0);
  CHECK(two->eta == Approx(0.605));
  CHECK(two->error < one->error);
  tests.add(lost(0.75));
  CHECK(tests.onset(Control::strain_path, false, 0)->error > 2 * two->error);
  CHECK_FALSE(tests.onset(Control::held_q_open, false, 0));
  CHECK_FALSE(tests.onset(Control::strain_path, true, 0));
}

TEST_CASE("a simulation knows its onset, also where it was not judged") {
  RecordHeader header = shear_header(AxialControl::displacement);
  header.origin = Origin::simulated;
  header.name = "by the law";
  TestSummary summary = collapse_at(0.62, 0.8);
  summary.truth = Truth{.lost_sustainability = true, .q_pa = -58e3, .p_eff_pa = 1e5};
  const std::vector<Forecast> forecasts{forecast(10, 0.7, 0.1)};
  auto said = earlier_test(header, summary, forecasts);
  REQUIRE(said);
  CHECK(said->name == "by the law (simulated)");
  CHECK(said->onset == 0.58);
  CHECK(said->onset_error == 0);
  CHECK(said->in_extension);
  CHECK(said->by_law);
  summary.collapse.withhold("its end");
  said = earlier_test(header, summary, forecasts);
  REQUIRE(said);
  CHECK(said->onset == 0.58);
  summary.truth->p_eff_pa.reset();  // a preamble that was edited
  CHECK_FALSE(earlier_test(header, summary, forecasts));
}

TEST_CASE("a simulation does not scatter as specimens do, the specimen to come does") {
  EarlierTest test = lost(0.60);
  test.onset_error = 0;
  EarlierTest simulation = test;
  simulation.by_law = true;
  EarlierTests tests, simulations;
  tests.add(test);
  simulations.add(simulation);
  const double of_test = tests.onset(Control::strain_path, false, 0)->error;
  const double of_law = simulations.onset(Control::strain_path, false, 0)->error;
  CHECK(of_law < 0.9 * of_test);
  CHECK(of_law > of_test / std::sqrt(2.0));
}

TEST_CASE("a simulation that carried on is none that collapsed, whatever its verdict") {
  RecordHeader header = shear_header(AxialControl::displacement);
  TestSummary summary = collapse_at(0.62);
  CHECK(earlier_test(header, summary, {})->onset == Approx(0.62));
  summary.truth = Truth{};
  CHECK_FALSE(earlier_test(header, summary, {}));
  summary.collapse.nearest = Nearest{.reading = 90, .normalised = 0.04};
  const auto said = earlier_test(header, summary, {});
  REQUIRE(said);
  CHECK_FALSE(said->onset);
  CHECK(said->min_work == 0.04);
}

TEST_CASE("a test whose pore fluid gave way as this one's does counts for more") {
  EarlierTests tests;
  tests.add(lost(0.60, 0));
  tests.add(lost(0.68, 0.25));
  CHECK(tests.onset(Control::strain_path, false, 0)->eta == Approx(0.60).margin(0.002));
  CHECK(tests.onset(Control::strain_path, false, 0.25)->eta == Approx(0.68).margin(0.002));
  EarlierTests stiff;
  stiff.add(lost(0.60, 0));
  CHECK(stiff.onset(Control::strain_path, false, 0.25)->error >
        5 * stiff.onset(Control::strain_path, false, 0)->error);
}

TEST_CASE("the least work of sound tests is known as long as none collapsed") {
  EarlierTests tests;
  CHECK_FALSE(tests.carried_on(Control::strain_path, false));
  tests.add(sound(0.1));
  tests.add(sound(0.02));
  CHECK(tests.carried_on(Control::strain_path, false) == 0.02);
  CHECK_FALSE(tests.carried_on(Control::held_q_shut, false));
  // What compression came through says nothing of extension, nor a collapse there of compression.
  CHECK_FALSE(tests.carried_on(Control::strain_path, true));
  EarlierTest other_way = lost(0.4);
  other_way.in_extension = true;
  tests.add(other_way);
  CHECK(tests.carried_on(Control::strain_path, false) == 0.02);
  tests.add(lost(0.6));
  CHECK_FALSE(tests.carried_on(Control::strain_path, false));
}

TEST_CASE("earlier tests agree on an onset where none that was driven so carried on") {
  EarlierTests tests;
  tests.add(lost(0.60));
  EarlierTest other_way = sound(0.1), held = sound(0.1);
  other_way.in_extension = true;
  held.control = Control::held_q_open;
  tests.add(other_way);
  tests.add(held);
  CHECK(tests.agree(Control::strain_path, false));
  tests.add(sound(0.1));
  CHECK_FALSE(tests.agree(Control::strain_path, false));
  CHECK(tests.onset(Control::strain_path, false, 0)->eta == Approx(0.60));
}

TEST_CASE("what a stored test says: its onset, with the error of its interval") {
  const RecordHeader header = shear_header(AxialControl::load);
  const auto said = earlier_test(header, collapse_at(-0.6), {});
  REQUIRE(said);
  CHECK(said->control == Control::strain_path);
  CHECK(said->in_extension);
  CHECK(*said->onset == Approx(0.6));
  CHECK(said->onset_error == Approx(0.01));
  CHECK(said->give == 0);
  CHECK_FALSE(said->by_law);

  TestSummary stable;
  stable.collapse.nearest = Nearest{.reading = 5, .normalised = 0.04, .error = 0.01};
  CHECK(earlier_test(header, stable, {})->min_work == 0.04);
  CHECK_FALSE(earlier_test(header, stable, {})->onset);
  CHECK_FALSE(earlier_test(header, stable, {})->in_extension);
  stable.peak = Instant{.reading = 3, .q_pa = -5e4, .p_eff_pa = 1e5};
  CHECK(earlier_test(header, stable, {})->in_extension);
  RecordHeader two = header;  // that the second stage is driven to no onset changes nothing
  two.stages.push_back(shear_header(AxialControl::displacement, Drainage::open).stages.front());
  CHECK(earlier_test(two, collapse_at(0.6), {})->control == Control::strain_path);
}

TEST_CASE("a test that says nothing of an onset to come is none") {
  const RecordHeader header = shear_header(AxialControl::load);
  TestSummary unjudged = collapse_at(0.6), on_limit = collapse_at(0.6), cut{};
  unjudged.collapse.judged = false;
  on_limit.collapse.inside_limit_surface = false;
  cut.collapse.nearest = Nearest{};
  cut.collapse.judged_until = 7;
  for (const TestSummary& one : {unjudged, on_limit, cut, TestSummary{}})
    CHECK_FALSE(earlier_test(header, one, {}));
  const RecordHeader drained = shear_header(AxialControl::displacement, Drainage::open);
  CHECK_FALSE(earlier_test(drained, collapse_at(0.6), {}));
}

TEST_CASE("where the pore fluid gave way the onset is the forecast that the path came up to") {
  const RecordHeader header = shear_header(AxialControl::load);
  // Passed once in the noise of the beginning, then ahead, and reached at reading 80; what was said
  // after the verdict's onset does not count.
  const std::vector<Forecast> forecasts = {forecast(10, 0.1, 0),    forecast(40, 0.7, 5e3),
                                           forecast(70, 0.66, 1e3), forecast(80, 0.65, 0),
                                           forecast(90, 0.655, 0),  forecast(110, 0.9, 1e3)};
  CHECK(*earlier_test(header, collapse_at(0.70, 0.8), forecasts)->onset == Approx(0.65));
  CHECK(earlier_test(header, collapse_at(0.70, 0.8), forecasts)->onset_error == Approx(0.01));
  CHECK(earlier_test(header, collapse_at(0.70, 0.8), forecasts)->give == Approx(0.25));
  CHECK(*earlier_test(header, collapse_at(0.70, 0.8), {})->onset == Approx(0.70));
  CHECK(*earlier_test(header, collapse_at(0.70, 0.98), forecasts)->onset == Approx(0.70));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/warning_history.hpp"

#include <catch2/catch.hpp>

#include "src/study/triaxial/test_result.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;

namespace {

lab::Forecast forecast_of_history(std::int64_t reading, double eta) {
  return {reading, 0.1 * static_cast<double>(reading), eta, eta - 0.1, eta + 0.1, {}};
}

/// Its onset is at reading 300, 30 s; forecasts from 60 to 120 and from 200 to 320.
TestResult foretold() {
  auto test = src::test::flow_test();
  for (int i = 60; i <= 320; i += 2)
    if (i <= 120 || i >= 200) test.curves.forecasts.push_back(forecast_of_history(i, 0.61));
  using enum lab::EventKind;
  test.stored.events = {{0, 0, stage_started, "stage 1", lab::Moment{0, 0.0}},
                        {250, 25, imminent, "soon", lab::Moment{250, 25.0}},
                        {300, 30, loss_of_sustainability, "fell", lab::Moment{400, 40.0}},
                        {310, 31, approaching, "known when the record had ended", {}}};
  return test;
}

bool has_mark(const WarningHistory& history, WarningMarkKind kind, double at) {
  for (const auto& mark : history.marks)
    if (mark.kind == kind && std::abs(mark.at - at) < 1e-9) return true;
  return false;
}

}  // namespace

TEST_CASE("what was forecast lies over the time of the stage, up to what became of it") {
  const auto found = warning_history(foretold());
  REQUIRE(found);
  CHECK(found->axis.begin == 0);
  CHECK(found->axis.end == Approx(40).margin(1.5));  // the loss was known there
  CHECK(found->axis.unit == 1);
  REQUIRE(found->forecasts.size() == 2);  // none between 12 and 20 s
  CHECK(found->forecasts[0].back().at == Approx(12));
  CHECK(found->forecasts[1].front().at == Approx(20));
  CHECK(found->forecasts[1].front().low == Approx(0.51));
  CHECK(found->forecasts[1].front().high == Approx(0.71));
  CHECK(has_mark(*found, WarningMarkKind::imminent, 25));  // when it was said
  CHECK(has_mark(*found, WarningMarkKind::lost, 40));
  CHECK(has_mark(*found, WarningMarkKind::onset, 30));  // where it was
  CHECK(found->marks.size() == 3);
  CHECK(found->eta.back().value == Approx(0.6).margin(0.3));
  CHECK(found->q.size() > 300);
}

TEST_CASE("along the readings of a record without time, too") {
  auto test = foretold();
  test.stored.header.has_time = false;
  for (auto& o : test.curves.forecasts) o.time_s.reset();
  const auto found = warning_history(test);
  REQUIRE(found);
  CHECK_FALSE(found->axis.along_time);
  CHECK(found->axis.unit == 1);
  CHECK(found->forecasts[0].front().at == 60);
  CHECK(has_mark(*found, WarningMarkKind::onset, 300));
}

TEST_CASE("marks are bounded, the last stand; without a forecast there is nothing to show") {
  auto test = foretold();
  for (int i = 0; i < 20; ++i)
    test.stored.events.insert(
        test.stored.events.begin() + 1,
        {100 + i, 10, lab::EventKind::warning_withdrawn, "", lab::Moment{100 + i, 10.0}});
  const auto found = warning_history(test);
  REQUIRE(found->marks.size() == kMostMarks);
  CHECK(has_mark(*found, WarningMarkKind::onset, 30));
  test.curves.forecasts.clear();
  CHECK_FALSE(warning_history(test));
}

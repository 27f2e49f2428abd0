// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/history_axis.hpp"

#include <catch2/catch.hpp>

#include "src/study/triaxial/test_result.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

TEST_CASE("along time an axis begins with shear, in the unit that suits its length") {
  auto test = sample::flow_test();
  auto axis = history_axis(test, Span::shear);
  REQUIRE(axis);
  CHECK(axis->along_time);
  CHECK(axis->from_shear);
  CHECK(axis->unit == 1);
  CHECK(axis->end == Approx(90));
  for (auto& state : test.curves.states) state.time_s = 1000 + 100 * state.time_s;  // 2.5 h
  axis = history_axis(test, Span::shear);
  CHECK(axis->unit == 60);
  CHECK(axis->origin == 1000);
  CHECK(*axis->position(1600, 0) == Approx(10));
  CHECK_FALSE(axis->position(999, 0));
  CHECK_FALSE(axis->position(lab::kMissing, 600));
}

TEST_CASE("a test that lasts a day has its axis in hours, also around its onset") {
  auto test = sample::flow_test();
  for (auto& state : test.curves.states) state.time_s *= 960;
  test.stored.summary.collapse.onset->time_s = 0.9 * 86400;
  CHECK(history_axis(test, Span::shear)->unit == 3600);
  CHECK(history_axis(test, Span::onset)->unit == 3600);
}

TEST_CASE("around the onset an axis without time shows as many readings as one with time") {
  auto test = sample::flow_test();
  test.stored.header.has_time = false;
  const auto axis = history_axis(test, Span::onset);
  REQUIRE(axis);
  CHECK(axis->begin == Approx(300 - 0.03 * 900));
  CHECK(axis->end == Approx(300 + 0.05 * 900));
}

TEST_CASE("around the onset an axis shows little before and after it") {
  const auto axis = history_axis(sample::flow_test(), Span::onset);
  REQUIRE(axis);
  CHECK(axis->begin == Approx(30 - 0.03 * 90));
  CHECK(axis->end == Approx(30 + 0.05 * 90));
  CHECK(*axis->position(30, 0) == Approx(30));  // since the start of shear
  CHECK_FALSE(history_axis(sample::stable_test(), Span::onset));
}

TEST_CASE("without time an axis goes along the readings; other stages than shear are left out") {
  const auto readings = history_axis(sample::stable_test(), Span::shear);
  REQUIRE(readings);
  CHECK_FALSE(readings->along_time);
  CHECK_FALSE(readings->from_shear);
  CHECK(readings->begin == 0);
  CHECK(readings->end == 500);
  CHECK(*readings->position(lab::kMissing, 167) == 167);
  CHECK_FALSE(readings->position(lab::kMissing, 501));
  auto test = sample::flow_test();
  test.stored.header.stages.push_back(
      {.number = 2, .name = "c", .role = lab::StageRole::consolidation});
  for (std::size_t i = 0; i < 100; ++i) test.curves.states[i].stage = 2;
  CHECK(history_axis(test, Span::shear)->begin == Approx(10));
}

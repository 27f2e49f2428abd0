#include "src/study/triaxial/history.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "src/study/triaxial/test_result.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

namespace {

std::vector<HistoryQuantity> quantities_of(const History& history) {
  std::vector<HistoryQuantity> quantities;
  for (const auto& curve : history.curves) quantities.push_back(curve.quantity);
  return quantities;
}

}  // namespace

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
  CHECK_FALSE(axis->position(lab::kMissing, 0.01));
}

TEST_CASE("a test that lasts a day has its axis in hours, also around its onset") {
  auto test = sample::flow_test();
  for (auto& state : test.curves.states) state.time_s *= 960;
  test.stored.summary.collapse.onset->time_s = 0.9 * 86400;
  CHECK(history_axis(test, Span::shear)->unit == 3600);
  CHECK(history_axis(test, Span::onset)->unit == 3600);
}

TEST_CASE("around the onset an axis shows little before and after it") {
  const auto axis = history_axis(sample::flow_test(), Span::onset);
  REQUIRE(axis);
  CHECK(axis->begin == Approx(30 - 0.03 * 90));
  CHECK(axis->end == Approx(30 + 0.05 * 90));
  CHECK(*axis->position(30, 0) == Approx(30));  // since the start of shear
  CHECK_FALSE(history_axis(sample::stable_test(), Span::onset));
}

TEST_CASE(
    "without time an axis goes along the axial strain; other stages than shear are left out") {
  const auto strain = history_axis(sample::stable_test(), Span::shear);
  REQUIRE(strain);
  CHECK_FALSE(strain->along_time);
  CHECK_FALSE(strain->from_shear);
  CHECK(*strain->position(lab::kMissing, 0.05) == Approx(5));
  auto test = sample::flow_test();
  test.stored.header.stages.push_back(
      {.number = 2, .name = "c", .role = lab::StageRole::consolidation});
  for (std::size_t i = 0; i < 100; ++i) test.curves.states[i].stage = 2;
  CHECK(history_axis(test, Span::shear)->begin == Approx(10));
}

TEST_CASE("a history has q, pore pressure and axial strain, volumetric strain in place of u") {
  using enum HistoryQuantity;
  auto test = sample::flow_test();
  CHECK(quantities_of(*history(test, Span::shear)) == std::vector{q, pore_pressure, axial_strain});
  for (auto& state : test.curves.states) state.pore_pressure = lab::kMissing;
  CHECK(quantities_of(*history(test, Span::shear)) ==
        std::vector{q, volumetric_strain, axial_strain});
  for (auto& state : test.curves.states) state.volumetric_strain = lab::kMissing;
  CHECK(quantities_of(*history(test, Span::shear)) == std::vector{q, axial_strain});
  CHECK(quantities_of(*history(sample::stable_test(), Span::shear)) ==
        std::vector{q, volumetric_strain});
}

TEST_CASE("curves hold the span, their extremes the whole test") {
  auto test = sample::flow_test();
  test.curves.states[295].q = lab::kMissing;
  const auto found = history(test, Span::onset);
  REQUIRE(found);
  const auto& q = found->curves.front();
  CHECK(q.points.front().at == Approx(27.3).margin(0.11));
  CHECK(q.points.back().at == Approx(34.5).margin(0.11));
  CHECK(std::none_of(q.points.begin(), q.points.end(),
                     [](const auto& point) { return point.at == Approx(29.5); }));
  CHECK(q.smallest == 0);
  CHECK(q.largest == Approx(60e3));
}

TEST_CASE("second-order work is placed by time, without time by the strain of its reading") {
  const auto timed = history(sample::flow_test(), Span::shear);
  REQUIRE(timed->work);
  CHECK(timed->work->front().at == Approx(1.5));
  CHECK(timed->work->front().error == 0.05);
  auto test = sample::stable_test();
  std::erase_if(test.curves.states, [](const auto& s) { return s.reading % 10 != 0; });
  const auto along_strain = history(test, Span::shear);
  CHECK(along_strain->work->front().at == Approx(100 * 0.15 * 15 / 500));  // between 10 and 20
  test.curves.work.clear();
  CHECK_FALSE(history(test, Span::shear)->work);
}

TEST_CASE("onset, true onset and failure are marked where they lie in the span") {
  auto test = sample::simulated_test();
  auto found = history(test, Span::shear);
  REQUIRE(found->marks.size() == 2);
  CHECK(found->marks[0].kind == HistoryMarkKind::onset);
  CHECK(found->marks[0].at == Approx(30));
  CHECK(found->marks[1].kind == HistoryMarkKind::true_onset);
  CHECK(found->marks[1].at == Approx(29.95));
  test.stored.summary.truth->time_s = 3;
  CHECK(history(test, Span::onset)->marks.size() == 1);
  test.stored.summary.truth->lost_sustainability = false;
  test.stored.summary.collapse.kind = lab::CollapseKind::none;
  found = history(test, Span::shear);
  REQUIRE(found->marks.size() == 1);
  CHECK(found->marks[0].kind == HistoryMarkKind::failure);
}

TEST_CASE("a test without states or without anything measured has no history") {
  auto nothing = sample::stable_test();
  for (auto& state : nothing.curves.states) {
    state.q = lab::kMissing;
    state.volumetric_strain = lab::kMissing;
  }
  nothing.curves.work.clear();
  CHECK_FALSE(history(nothing, Span::shear));
  nothing.curves = {};
  CHECK_FALSE(history(nothing, Span::shear));
}

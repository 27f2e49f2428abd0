// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/history.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

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
        std::vector{q, volumetric_strain, axial_strain});
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

TEST_CASE("history: second-order work has a gap at an unread step") {
  auto test = sample::flow_test();
  REQUIRE(test.curves.work.size() > 1);
  const auto count = [&] {
    const auto work = *history(test, Span::shear)->work;
    return std::ranges::count_if(work, [](const auto& w) { return std::isnan(w.normalised); });
  };
  CHECK(count() == 0);
  test.curves.breaks.unread_steps = {test.curves.work[1].reading};
  CHECK(count() == 1);
}

TEST_CASE("second-order work is placed by time, without time by its reading") {
  const auto timed = history(sample::flow_test(), Span::shear);
  REQUIRE(timed->work);
  CHECK(timed->work->front().at == Approx(1.5));
  CHECK(timed->work->front().error == 0.05);
  auto test = sample::stable_test();
  CHECK(history(test, Span::shear)->work->front().at == 15);
  test.curves.work.clear();
  CHECK_FALSE(history(test, Span::shear)->work);
}

TEST_CASE("without time what is unloaded and loaded again is drawn in its order") {
  auto test = sample::stable_test();
  for (auto& state : test.curves.states)  // to ε₁ = 7.5 % and back
    if (state.reading > 250) state.strain.axial = 3e-4 * static_cast<double>(500 - state.reading);
  const auto found = history(test, Span::shear);
  REQUIRE(found);
  for (const auto& curve : found->curves) {
    REQUIRE(curve.points.size() == 501);
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      REQUIRE(curve.points[i].at == static_cast<double>(i));
  }
  const auto& strain = found->curves.back();
  CHECK(strain.points[250].value == Approx(0.075));
  CHECK(strain.points[500].value == Approx(0).margin(1e-12));
}

TEST_CASE("a truth, which knows its time only, is not marked along readings") {
  auto test = sample::simulated_test();
  test.stored.header.has_time = false;
  const auto found = history(test, Span::shear);
  REQUIRE(found->marks.size() == 1);
  CHECK(found->marks[0].kind == HistoryMarkKind::onset);
  CHECK(found->marks[0].at == 300);
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

TEST_CASE("history: the loss of control is marked beside the onset", "[study]") {
  auto test = sample::simulated_test();
  test.stored.summary.truth.reset();
  test.stored.summary.collapse.loss_of_control = lab::Instant{.reading = 320, .time_s = 32.0};
  const auto found = history(test, Span::shear);
  REQUIRE(found->marks.size() == 2);
  CHECK(found->marks[1].kind == HistoryMarkKind::loss_of_control);
  CHECK(found->marks[1].at == Approx(32));
}

TEST_CASE("a test without states or without anything measured has no history") {
  auto nothing = sample::stable_test();
  for (auto& state : nothing.curves.states) {
    state.q = lab::kMissing;
    state.volumetric_strain = lab::kMissing;
    state.strain.axial = lab::kMissing;
  }
  nothing.curves.work.clear();
  CHECK_FALSE(history(nothing, Span::shear));
  nothing.curves = {};
  CHECK_FALSE(history(nothing, Span::shear));
}

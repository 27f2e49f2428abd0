// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/history.hpp"

#include <algorithm>
#include <cmath>

#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

double value_of(const lab::State& state, HistoryQuantity quantity) {
  switch (quantity) {
    case HistoryQuantity::q:
      return state.q;
    case HistoryQuantity::pore_pressure:
      return state.pore_pressure;
    case HistoryQuantity::volumetric_strain:
      return state.volumetric_strain;
    case HistoryQuantity::axial_strain:
      return state.strain.axial;
  }
  return lab::kMissing;
}

bool measured(const Curves& curves, HistoryQuantity quantity) {
  return std::any_of(curves.states.begin(), curves.states.end(),
                     [&](const auto& state) { return std::isfinite(value_of(state, quantity)); });
}

std::vector<HistoryQuantity> quantities_of(const Curves& curves) {
  using enum HistoryQuantity;
  std::vector<HistoryQuantity> chosen{
      q, measured(curves, pore_pressure) ? pore_pressure : volumetric_strain, axial_strain};
  std::erase_if(chosen, [&](auto quantity) { return !measured(curves, quantity); });
  return chosen;
}

HistoryCurve curve_of(const Curves& curves, HistoryQuantity quantity, const HistoryAxis& axis) {
  HistoryCurve curve{quantity, {}, 0, 0};
  bool any = false;
  Joiner joiner(curves.breaks);
  for (const auto& state : curves.states) {
    const double value = value_of(state, quantity);
    if (!std::isfinite(value)) {
      joiner.skip(state);
      continue;
    }
    curve.smallest = any ? std::min(curve.smallest, value) : value;
    curve.largest = any ? std::max(curve.largest, value) : value;
    any = true;
    if (const auto at = axis.position(state.time_s, state.reading))
      curve.points.push_back({*at, value, joiner.join(state)});
  }
  return curve;
}

std::vector<HistoryWork> work_of(const Curves& curves, const HistoryAxis& axis) {
  std::vector<HistoryWork> work;
  std::int64_t before = -1;
  for (const auto& point : curves.work) {
    const auto at = axis.position(point.time_s, point.reading);
    if (!at || !std::isfinite(point.work.normalised)) continue;
    const double error = std::isfinite(point.normalised_error) ? point.normalised_error : 0;
    const bool gap = before >= 0 && (curves.breaks.has_fault_between(before, point.reading) ||
                                     curves.breaks.is_unread(before, point.reading));
    if (gap) work.push_back({*at, lab::kMissing, 0});
    before = point.reading;
    work.push_back({*at, point.work.normalised, error});
  }
  return work;
}

std::vector<HistoryMark> marks_of(const db::StoredTest& test, const HistoryAxis& axis) {
  std::vector<HistoryMark> marks;
  const auto add = [&](const std::optional<lab::Instant>& instant, HistoryMarkKind kind) {
    if (!instant) return;
    const auto at = axis.position(instant->time_s.value_or(lab::kMissing), instant->reading);
    if (at) marks.push_back({*at, kind});
  };
  add(collapse_onset(test), HistoryMarkKind::onset);
  add(test.summary.collapse.loss_of_control, HistoryMarkKind::loss_of_control);
  add(failure_onset(test), HistoryMarkKind::failure);
  // The truth knows its time only.
  const auto& truth = test.summary.truth;
  if (axis.along_time && truth && truth->lost_sustainability)
    add(true_instant(*truth), HistoryMarkKind::true_onset);
  return marks;
}

}  // namespace

std::optional<History> history(const TestResult& test, Span span) {
  const auto axis = history_axis(test, span);
  if (!axis) return std::nullopt;
  History found;
  found.test = test.stored.header.name;
  found.span = span;
  found.axis = *axis;
  for (const auto quantity : quantities_of(test.curves))
    found.curves.push_back(curve_of(test.curves, quantity, *axis));
  if (!test.curves.work.empty()) found.work = work_of(test.curves, *axis);
  if (found.curves.empty() && !found.work) return std::nullopt;
  found.marks = marks_of(test.stored, *axis);
  found.origin.add(test.stored);
  return found;
}

}  // namespace triax::study

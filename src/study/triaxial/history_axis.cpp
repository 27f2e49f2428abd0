// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/history_axis.hpp"

#include <algorithm>
#include <cmath>

#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

// Beside the onset, so much of the shear stage is shown before and after it: enough to see the
// rates change, little enough that a collapse of seconds is wider than a line.
constexpr double kBeforeOnset = 0.03;
constexpr double kAfterOnset = 0.05;

double value_of(const lab::State& state, bool along_time) {
  return along_time ? state.time_s : static_cast<double>(state.reading);
}

bool in_shear(const lab::RecordHeader& header, const lab::State& state, bool shear_known) {
  const auto* stage = header.stage(state.stage);
  return !shear_known || (stage != nullptr && stage->role == lab::StageRole::shear);
}

/// False where nothing is left to show.
bool narrow_to_onset(HistoryAxis& axis, const std::optional<lab::Instant>& onset) {
  if (!onset) return false;
  const double at =
      axis.along_time ? onset->time_s.value_or(lab::kMissing) : static_cast<double>(onset->reading);
  if (std::isnan(at)) return false;
  const double length = axis.end - axis.begin;
  axis.begin = std::max(axis.begin, at - kBeforeOnset * length);
  axis.end = std::min(axis.end, at + kAfterOnset * length);
  return axis.end > axis.begin;
}

/// From 0 of the axis, not from where a close view begins: it has the unit of the whole.
double unit_for(const HistoryAxis& axis) {
  if (!axis.along_time) return 1;
  const double longest_s = axis.end - axis.origin;
  return longest_s <= 3600 ? 1 : longest_s <= 6 * 3600 ? 60 : 3600;
}

}  // namespace

std::optional<double> HistoryAxis::place(double si) const {
  if (!std::isfinite(si) || si < begin || si > end) return std::nullopt;
  return (si - origin) / unit;
}

std::optional<HistoryAxis> history_axis(const TestResult& test, Span span) {
  const auto& header = test.stored.header;
  HistoryAxis axis;
  axis.along_time = header.has_time;
  const bool shear_known =
      std::any_of(header.stages.begin(), header.stages.end(),
                  [](const auto& stage) { return stage.role == lab::StageRole::shear; });
  bool any = false;
  for (const auto& state : test.curves.states) {
    const double value = value_of(state, axis.along_time);
    if (!std::isfinite(value) || !in_shear(header, state, shear_known)) continue;
    axis.begin = any ? std::min(axis.begin, value) : value;
    axis.end = any ? std::max(axis.end, value) : value;
    any = true;
  }
  if (!any || axis.end <= axis.begin) return std::nullopt;
  if (axis.along_time) axis.origin = axis.begin;
  axis.from_shear = shear_known;
  if (span == Span::onset && !narrow_to_onset(axis, collapse_onset(test.stored)))
    return std::nullopt;
  axis.unit = unit_for(axis);
  return axis;
}

HistoryAxis narrowed(HistoryAxis axis, double begin, double end) {
  axis.begin = begin;
  axis.end = end;
  axis.unit = unit_for(axis);
  return axis;
}

}  // namespace triax::study

#include "src/triaxial/figures/history_axis.hpp"

#include <algorithm>
#include <cmath>

namespace triax::src {
namespace {

// Beside the onset, so much of the shear stage is shown before and after it: enough to see the
// rates change, little enough that a collapse of seconds is wider than a line.
constexpr double kBeforeOnset = 0.03;
constexpr double kAfterOnset = 0.05;

double value_of(const lab::State& state, bool along_time) {
  return along_time ? state.time_s : state.strain.axial;
}

bool in_shear(const lab::RecordHeader& header, const lab::State& state, bool shear_known) {
  const auto* stage = header.stage(state.stage);
  return !shear_known || (stage != nullptr && stage->role == lab::StageRole::shear);
}

void choose_time_unit(HistoryAxis& axis, const std::string& since) {
  const double longest = axis.end - axis.origin;  // a close view keeps the unit of the whole
  axis.unit = longest <= 3600 ? 1 : longest <= 6 * 3600 ? 60 : 3600;
  axis.title = "time " + since + (axis.unit == 1 ? " (s)" : axis.unit == 60 ? " (min)" : " (h)");
}

}  // namespace

std::optional<double> HistoryAxis::position(double time_s, double axial_strain) const {
  const double si = along_time ? time_s : axial_strain;
  if (!std::isfinite(si) || si < begin || si > end) return std::nullopt;
  return (si - origin) / unit;
}

std::optional<HistoryAxis> history_axis(const study::TestResult& test, Span span) {
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

  if (span == Span::onset) {
    const auto onset = study::collapse_onset(test.stored);
    const auto at = !onset ? std::nullopt : axis.along_time ? onset->time_s : onset->axial_strain;
    if (!at) return std::nullopt;
    const double length = axis.end - axis.begin;
    const double start = axis.begin;
    axis.begin = std::max(start, *at - kBeforeOnset * length);
    axis.end = std::min(axis.end, *at + kAfterOnset * length);
    if (axis.end <= axis.begin) return std::nullopt;
  }
  if (axis.along_time) {
    choose_time_unit(axis, shear_known ? "since start of shear" : "since start of record");
  } else {
    axis.unit = 0.01;
    axis.title = "axial strain ε₁ (%), no time in the record";
  }
  return axis;
}

}  // namespace triax::src

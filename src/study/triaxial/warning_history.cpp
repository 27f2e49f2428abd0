// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/warning_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

constexpr double kBehindOnset = 0.15,
                 kBehindLoss = 0.03;  ///< of the way from the start to the onset

/// Positions along an axis: times in s, or numbers of readings.
struct Along {
  bool time = true;

  double at(std::int64_t reading, const std::optional<double>& time_s) const {
    return time ? time_s.value_or(lab::kMissing) : static_cast<double>(reading);
  }
  double at(const lab::Instant& instant) const { return at(instant.reading, instant.time_s); }
  double at(const lab::State& state) const { return at(state.reading, state.time_s); }
};

struct Found {
  double si;
  WarningMarkKind kind;
};

std::optional<WarningMarkKind> mark_of(lab::EventKind kind) {
  switch (kind) {
    case lab::EventKind::approaching:
      return WarningMarkKind::approaching;
    case lab::EventKind::imminent:
      return WarningMarkKind::imminent;
    case lab::EventKind::warning_withdrawn:
      return WarningMarkKind::taken_back;
    case lab::EventKind::loss_of_sustainability:
      return WarningMarkKind::lost;
    default:
      return std::nullopt;
  }
}

std::vector<Found> marks_found(const TestResult& test, const Along& along) {
  std::vector<Found> found;
  for (const lab::Event& event : test.stored.events)
    if (const auto kind = mark_of(event.kind); kind && event.detected_at)
      found.push_back({along.at(event.detected_at->reading, event.detected_at->time_s), *kind});
  if (const auto onset = collapse_onset(test.stored))
    found.push_back({along.at(*onset), WarningMarkKind::onset});
  if (const auto failure = failure_onset(test.stored))
    found.push_back({along.at(*failure), WarningMarkKind::failure});
  // The truth knows its time only.
  const auto& truth = test.stored.summary.truth;
  if (along.time && truth && truth->lost_sustainability)
    found.push_back({along.at(true_instant(*truth)), WarningMarkKind::true_onset});
  return found;
}

/// Where the stage with that reading began.
double start_of_stage(const TestResult& test, const Along& along, std::int64_t reading) {
  double start = lab::kMissing;
  for (const lab::Event& event : test.stored.events)
    if (event.kind == lab::EventKind::stage_started && event.reading <= reading)
      start = along.at(event.reading, event.time_s);
  return start;
}

/// Of a record with few readings some are to be seen behind its onset.
double some_behind(const TestResult& test, const Along& along) {
  constexpr std::int64_t kSome = 3;
  const auto& onset = test.stored.summary.collapse.onset;
  const auto& states = test.curves.states;
  if (!onset || states.empty()) return lab::kMissing;
  const auto first = std::ranges::upper_bound(states, onset->reading, {}, &lab::State::reading);
  const auto left = states.end() - first;
  return left == 0 ? lab::kMissing : along.at(first[std::min(left, kSome) - 1]);
}

HistoryAxis narrowed_to_warning(const HistoryAxis& shear, const TestResult& test,
                                const Along& along, const std::vector<Found>& marks) {
  const double start = start_of_stage(test, along, test.curves.forecasts.front().reading);
  const double begin = std::isfinite(start) ? std::max(start, shear.begin) : shear.begin;
  double end = -std::numeric_limits<double>::infinity();
  for (const Found& mark : marks) {
    const bool of_onset = mark.kind == WarningMarkKind::onset ||
                          mark.kind == WarningMarkKind::failure ||
                          mark.kind == WarningMarkKind::true_onset;
    if (of_onset && mark.si > begin)
      end = std::max(end, mark.si + kBehindOnset * (mark.si - begin));
  }
  if (const double behind = some_behind(test, along); std::isfinite(end) && behind > end)
    end = std::min(behind, begin + 2 * (end - begin));
  const double length = end - begin;
  for (const Found& mark : marks)
    if (mark.kind == WarningMarkKind::lost && mark.si < begin + 2 * length)
      end = std::max(end, mark.si + kBehindLoss * length);
  return narrowed(shear, begin, std::isfinite(end) ? std::min(end, shear.end) : shear.end);
}

/// Points of second-order work between two readings: with a forecast each is followed by one.
std::int64_t works_between(const Curves& curves, std::int64_t from, std::int64_t to) {
  const auto place = [&](std::int64_t reading) {
    return std::ranges::lower_bound(curves.work, reading, {}, &lab::SecondOrderWorkPoint::reading);
  };
  return place(to) - place(from);
}

std::vector<std::vector<ForecastPoint>> runs_of(const Curves& curves, const Along& along,
                                                const HistoryAxis& axis) {
  const auto& all = curves.forecasts;
  // Of long tests neither are all here.
  const auto usual =
      static_cast<std::int64_t>(curves.work.size() / std::max<std::size_t>(all.size(), 1));
  const std::int64_t most = 4 + 2 * usual;
  std::vector<std::vector<ForecastPoint>> runs;
  std::int64_t before = -1;
  for (const lab::Forecast& o : all) {
    const auto at = axis.place(along.at(o.reading, o.time_s));
    if (!at) continue;
    if (before < 0 || works_between(curves, before, o.reading) > most) runs.emplace_back();
    before = o.reading;
    runs.back().push_back({*at, o.eta, o.eta_low, o.eta_high});
  }
  return runs;
}

}  // namespace

std::optional<WarningHistory> warning_history(const TestResult& test) {
  const auto shear = history_axis(test, Span::shear);
  if (!shear || test.curves.forecasts.empty()) return std::nullopt;
  const Along along{shear->along_time};
  const auto marks = marks_found(test, along);
  WarningHistory found;
  found.test = test.stored.header.name;
  found.axis = narrowed_to_warning(*shear, test, along, marks);
  if (found.axis.end <= found.axis.begin) return std::nullopt;
  Joiner of_eta(test.curves.breaks), of_q(test.curves.breaks);
  for (const lab::State& state : test.curves.states) {
    const auto at = found.axis.place(along.at(state));
    if (!at) continue;
    const auto add = [&](std::vector<HistoryPoint>& points, double value, bool known,
                         Joiner& joiner) {
      if (known)
        points.push_back({*at, value, joiner.join(state)});
      else
        joiner.skip(state);
    };
    // Beyond these the lesser principal stress is tension: p′ is lost in its scatter.
    add(found.eta, state.eta(), state.eta() >= -1.5 && state.eta() <= 3, of_eta);
    add(found.q, state.q, std::isfinite(state.q), of_q);
  }
  found.forecasts = runs_of(test.curves, along, found.axis);
  if (found.forecasts.empty()) return std::nullopt;
  for (const Found& mark : marks)
    if (const auto at = found.axis.place(mark.si)) found.marks.push_back({*at, mark.kind});
  if (found.marks.size() > kMostMarks)
    found.marks.erase(found.marks.begin(), found.marks.end() - kMostMarks);
  found.origin.add(test.stored);
  return found;
}

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What was said while a test ran, and how that compares with what became of it.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"

namespace triax::study {

/// An event, or a forecast between events.
struct LiveRow {
  std::optional<lab::Moment> said;  ///< when; empty: only when the record had ended, or not known
  std::optional<int> stage;         ///< then
  std::optional<double> eta;        ///< q/p′ then
  std::optional<lab::Event> event;
  std::optional<lab::Forecast> forecast;  ///< what was forecast then
};

/// A level that was said and not taken back, held against the onset that came.
struct LiveLead {
  lab::Forecast forecast;
  std::int64_t readings = 0;     ///< before the onset; negative: after it
  std::optional<double> time_s;  ///< likewise
};

struct LiveAccount {
  std::vector<LiveRow> rows;   ///< in the order in which it was said; what came to light last, last
  std::int64_t forecasts = 0;  ///< all that were made
  std::int64_t shown = 0;      ///< of them in rows without an event
  /// Of a collapse, or of a failure. Empty: there was none, or the test has no verdict.
  std::optional<lab::Instant> onset;
  std::optional<LiveLead> approaching, imminent;  ///< only with an onset
};

/// Every event, and of the forecasts in each stage, up to the onset that came or the stage's end:
/// the first in every tenth of its readings, the last, and, kMoves at most, those that lie outside
/// the interval of the one shown before. So there are at most 12 + kMoves rows a stage beside
/// events.
LiveAccount live_account(const db::Store& store, const db::StoredTest& test);

inline constexpr int kMoves = 10;

}  // namespace triax::study

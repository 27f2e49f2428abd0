// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an alarm forecast along a test, beside what came.
#include <optional>
#include <string>
#include <vector>

#include "src/study/triaxial/history.hpp"

namespace triax::study {

struct ForecastPoint {
  double at = 0;                      ///< along the axis, in its units
  double eta = 0, low = 0, high = 0;  ///< at the onset to come, with 90 %
};

enum class WarningMarkKind { approaching, imminent, taken_back, lost, onset, failure, true_onset };

struct WarningMark {
  double at = 0;  ///< along the axis, in its units: where it was said, or where the onset was
  WarningMarkKind kind = WarningMarkKind::onset;
};

struct WarningHistory {
  std::string test;  ///< its name
  HistoryAxis axis;
  std::vector<HistoryPoint> eta;  ///< q/p′ as measured
  std::vector<HistoryPoint> q;    ///< Pa
  /// Apart where no onset was forecast at points of second-order work in between.
  std::vector<std::vector<ForecastPoint>> forecasts;
  std::vector<WarningMark> marks;  ///< those within the axis, kMostMarks at most, the last of them
  TestsOrigin origin;
};

inline constexpr std::size_t kMostMarks = 8;

/// From the start of the first stage with a forecast to some time after the onset, so far that the
/// mark of its loss is within, or without an onset to the end of shear. Nothing where nothing was
/// forecast.
std::optional<WarningHistory> warning_history(const TestResult& test);

}  // namespace triax::study

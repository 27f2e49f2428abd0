// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The common axis of the histories of one test.
#include <cstdint>
#include <optional>

namespace triax::study {

struct TestResult;

enum class Span {
  shear,  ///< the shear stages; the whole record where no stage is known to be shear
  onset,  ///< the neighbourhood of the onset of collapse
};

struct HistoryAxis {
  bool along_time = true;  ///< false: no time in the record, along the number of the reading
  bool from_shear = true;  ///< 0 is the start of shear; false: of the record
  double unit = 1;         ///< SI value of one unit of the axis: s, min, h; 1 for readings
  double origin = 0;       ///< SI value at 0 of the axis: where the span begins for a time axis
  double begin = 0;        ///< SI, or number of a reading
  double end = 0;          ///< likewise

  /// In units of the axis, from its 0; nothing for a value outside the span or unknown.
  std::optional<double> position(double time_s, std::int64_t reading) const {
    return place(along_time ? time_s : static_cast<double>(reading));
  }
  /// The same of a time or reading, whichever the axis has.
  std::optional<double> place(double si) const;
};

/// Nothing where the test has no state in the span.
std::optional<HistoryAxis> history_axis(const TestResult& test, Span span);

/// The same axis over another stretch of it, in the unit that fits that.
HistoryAxis narrowed(HistoryAxis axis, double begin, double end);

}  // namespace triax::study

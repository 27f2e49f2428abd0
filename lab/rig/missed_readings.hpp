// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

namespace triax::lab {

/// Reports readings that were not taken when they were due: instruments or machine are too slow, or
/// the program stood still. A gap is reported with both ends; of gaps that follow each other
/// without a reading in time between them, the first so, the second as the begin of many, and their
/// end.
class MissedReadings {
 public:
  /// A reading that was due at `due_s` was taken at `time_s`; the next is due `interval_s` after
  /// that instant. Returns a sentence to report, if there is one.
  std::optional<std::string> add(double due_s, double time_s, double interval_s);

 private:
  int late_in_a_row_ = 0;
};

}  // namespace triax::lab

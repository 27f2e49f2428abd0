// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "lab/records/findings.hpp"

namespace triax::lab {

/// Builds a strictly increasing test time from the stamps of a file.
///
/// With a time within the stage: start of the stage + stage time, the start being where the test
/// time of its first row puts it, or where the stage before ended. Without: the stamp as it is. A
/// stamp that does not lie behind the last one is set a thousandth of the smallest step behind it;
/// where a clock ran back, the stamps after it are shifted along until they are ahead again by
/// themselves. Every change is a finding. A stamp that needs no change keeps its bits.
class TimeLine {
 public:
  TimeLine(bool has_test_time, bool has_stage_time)
      : has_test_time_(has_test_time), has_stage_time_(has_stage_time) {}

  /// Test time (s) of the next row; NaN where the record has no time at all. `stage_begins` is true
  /// for the first row of each stage.
  double next(double test_time_s, double stage_time_s, int stage, bool stage_begins,
              std::int64_t line, Findings& findings);
  /// True after two rows or more that all bear one stamp.
  bool stands_still() const { return rows_ > 1 && !moved_; }
  std::int64_t rows() const { return rows_; }

 private:
  double stamp(double test_time_s, double stage_time_s, int stage, bool stage_begins,
               std::int64_t line, Findings& findings);
  double least_step() const;
  void repair(double& time, std::int64_t line, Findings& findings);

  bool has_test_time_;
  bool has_stage_time_;
  std::int64_t rows_ = 0;
  bool moved_ = false;
  double last_ = 0;        // test time given last
  double last_stamp_ = 0;  // stamp it came from
  double offset_ = 0;
  double stage_start_ = 0;
  double smallest_step_ = 0;
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/time_line.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lab/results/reading.hpp"

namespace triax::lab {

double TimeLine::least_step() const {
  const double step = smallest_step_ > 0 ? smallest_step_ / 1000 : 1e-3;
  // Far from zero a step can be lost in rounding.
  return std::max(step, 4 * (std::nextafter(std::abs(last_), HUGE_VAL) - std::abs(last_)));
}

double TimeLine::next(double test_time_s, double stage_time_s, int stage, bool stage_begins,
                      std::int64_t line, Findings& findings) {
  if (!has_test_time_ && !has_stage_time_) return kMissing;
  const double raw = has_stage_time_ ? stage_time_s : test_time_s;
  double time = stamp(test_time_s, stage_time_s, stage, stage_begins, line, findings);
  if (std::isnan(raw)) {
    findings.note("time missing", line,
                  "no time in this row: the time is set just after that of the previous row");
    time = rows_ == 0 ? 0 : last_ + least_step();
  } else if (rows_ > 0) {
    repair(time, line, findings);
  }
  if (rows_ > 0 && !stage_begins && raw > last_stamp_) {
    const double step = raw - last_stamp_;
    smallest_step_ = smallest_step_ > 0 ? std::min(smallest_step_, step) : step;
  }
  if (rows_ > 0 && (raw != last_stamp_ || (stage_begins && has_stage_time_))) moved_ = true;
  if (!std::isnan(raw)) last_stamp_ = raw;
  last_ = time;
  ++rows_;
  return time;
}

double TimeLine::stamp(double test_time_s, double stage_time_s, int stage, bool stage_begins,
                       std::int64_t line, Findings& findings) {
  if (!has_stage_time_) return test_time_s;
  if (stage_begins || rows_ == 0) {
    const bool placed = has_test_time_ && !std::isnan(test_time_s);
    stage_start_ = placed ? test_time_s - stage_time_s : last_ - stage_time_s;
    offset_ = 0;
    if (std::isnan(stage_start_)) stage_start_ = last_;
    const double begins = stage_start_ + stage_time_s;
    if (rows_ > 0 && begins <= last_) {
      const double shift = last_ + least_step() - begins;
      stage_start_ += shift;
      if (placed)
        findings.note("stage time back", line,
                      fmt::format("stage {} begins at {:g} s, but the previous stage ended at {:g} "
                                  "s: the stage is moved {:g} s later",
                                  stage, begins, last_, shift));
      else
        findings.note("stage time joined", line,
                      fmt::format("the time restarts with stage {}: it is joined to the end of the "
                                  "previous stage, {:g} s",
                                  stage, last_));
    }
  }
  return stage_start_ + stage_time_s;
}

void TimeLine::repair(double& time, std::int64_t line, Findings& findings) {
  if (offset_ != 0 && time > last_) {
    offset_ = 0;
    return;
  }
  const double shifted = offset_ == 0 ? time : time + offset_;
  if (shifted > last_) {
    time = shifted;
    return;
  }
  const double behind = last_ + least_step();
  if (shifted == last_) {
    findings.note("time repeated", line, [&] {
      return fmt::format("the time {:g} s appears twice: the second is moved {:g} s later", time,
                         behind - last_);
    });
  } else {
    findings.note("time back", line, [&] {
      return fmt::format(
          "the time decreases from {:g} s to {:g} s: it is shifted by {:g} s from here on, until "
          "it increases",
          last_, time, behind - time);
    });
    offset_ = behind - time;
  }
  time = behind;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All that was said of one test while it ran, in order, against the specimen's truth.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/warning/alarm_trial.hpp"
#include "lab/rig/back_end.hpp"
#include "lab/rig/session.hpp"

namespace triax::bench {

class Heard {
 public:
  /// Of a session. To be kept as long as the session runs.
  lab::SessionListener listener();
  /// Into the trial; `truth` of a specimen that lost sustainability, null of another.
  void judge(const lab::Truth* truth, AlarmTrial& trial) const;
  /// When the stage of the onset began, and its number.
  struct Begin {
    int stage = 0;
    double time_s = 0;
    std::int64_t reading = 0;
  };
  Begin stage_at(double time_s) const;

 private:
  struct Level {
    double time_s;
    lab::WarningLevel level;
  };
  struct Forecast {
    double known_s;
    int stage;
    double eta_now;
    lab::Forecast forecast;
  };
  lab::WarningLevel level() const {
    return levels_.empty() ? lab::WarningLevel::none : levels_.back().level;
  }
  std::optional<double> stood_since(double time_s) const;
  void judge_collapse(const lab::Truth& truth, AlarmTrial& trial) const;

  std::optional<int> stage_;
  double now_s_ = 0, eta_ = 0;
  std::vector<double> times_;
  std::vector<Level> levels_;
  std::vector<Forecast> forecasts_;
  std::vector<Begin> begins_;
  std::int64_t points_ = 0, wrong_points_ = 0;
};

}  // namespace triax::bench

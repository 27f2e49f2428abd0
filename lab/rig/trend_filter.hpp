// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::lab {

/// Level and trend of a noisy signal in critical damping, as a servo's software smooths what it
/// reads. A steady ramp is followed without a lag; of white noise of the size 1 about √(5 dt/4τ)
/// stays in the level.
class TrendFilter {
 public:
  explicit TrendFilter(double time_constant_s = 0) : time_constant_s_(time_constant_s) {}

  /// Without a time constant nothing is smoothed, and nobody should ask.
  bool active() const { return time_constant_s_ > 0; }
  double time_constant_s() const { return time_constant_s_; }
  void start(double level, double rate);
  /// The value read dt after the last one.
  void take(double value, double dt_s);
  double level() const { return level_; }
  double expected(double dt_s) const { return level_ + rate_ * dt_s; }

 private:
  double time_constant_s_;
  double level_ = 0, rate_ = 0;
};

}  // namespace triax::lab

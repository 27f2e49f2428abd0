// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

namespace triax::lab {

/// The noise of a signal from reading to reading, in its unit and in constant memory. Where the
/// signal is smooth, however coarse the readings, one bend x − (x₋ + x₊)/2 follows another of its
/// kind; noise bends to and fro. The mean of the smaller of two neighbouring bends of opposite
/// sign, 0 where they agree: (√6 − 1)/√(2π) = 0.578 standard deviations of white noise.
class BendNoise {
 public:
  static constexpr double kOfDeviation = 0.578;  ///< value() over a standard deviation

  void add(double value) {
    const double bend = last_[1] - (last_[0] + value) / 2;
    if (++in_row_ > 3) {
      const bool to_and_fro = bend * bend_ < 0;
      const double noise = to_and_fro ? std::min(std::fabs(bend), std::fabs(bend_)) : 0;
      mean_ += (noise - mean_) / ++pairs_;
    }
    bend_ = in_row_ > 2 ? bend : 0;
    last_ = {last_[1], value};
  }
  /// The next value is no neighbour of the last: what was learnt stands, no bend goes across.
  void interrupt() { in_row_ = 0; }
  double value() const { return mean_; }

 private:
  std::array<double, 2> last_{};
  double bend_ = 0, mean_ = 0;
  int in_row_ = 0, pairs_ = 0;
};

}  // namespace triax::lab

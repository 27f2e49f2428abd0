// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is done without statistics: three ways to look for a collapse in a table of numbers. They
// get the same reduced states as the monitor, in the stages that it watches.
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "lab/results/state.hpp"

namespace triax::bench {

/// What one method says of a test.
struct Onset {
  std::int64_t reading = 0;
  double eta = 0;  ///< q/p' there, as measured
};

/// Onset = the largest |q|, if |q| fell by a tenth of it before the test was over. Known only after
/// the test.
class MaximumOfQ {
 public:
  static constexpr double kLoss = 0.1;

  void add(const lab::State& state);
  std::optional<Onset> onset() const;

 private:
  double top_ = -1, least_after_ = 0;
  Onset at_top_;
};

/// Onset = first reading at which Δq Δε_q + Δp′ Δε_v between neighbours is negative.
class NeighbouringIncrements {
 public:
  void add(const lab::State& state);
  /// Increments across a change of stage mean nothing.
  void start_stage() { last_.reset(); }
  std::optional<Onset> onset() const { return onset_; }

 private:
  std::optional<lab::State> last_;
  std::optional<Onset> onset_;
};

/// The same between successive moving averages of `window` readings; onset = the first of `window`
/// negative ones in a row, at the middle of its average.
class MovingAverage {
 public:
  explicit MovingAverage(std::size_t window) : window_(window) {}
  void add(const lab::State& state);
  void start_stage();
  std::optional<Onset> onset() const { return onset_; }

 private:
  std::size_t window_;
  std::deque<lab::State> states_;
  std::size_t run_ = 0;
  Onset start_of_run_;
  std::optional<Onset> onset_;
};

/// Δq Δε_q + Δp′ Δε_v, Eq. (23), with ε_q = ε₁ − ε_v/3.
double second_order_work(double dq, double dp, double axial, double volumetric);

}  // namespace triax::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A test of a million scans drawn with some thousand points that still hold every peak.
#include <cstdint>
#include <vector>

#include "lab/results/forecast.hpp"
#include "lab/results/second_order_work_point.hpp"
#include "lab/results/state.hpp"
#include "src/study/triaxial/line_breaks.hpp"

namespace triax::study {

struct Curves {
  std::vector<lab::State> states;               ///< in order
  std::vector<lab::SecondOrderWorkPoint> work;  ///< in order
  std::vector<lab::Forecast> forecasts;         ///< in order
  LineBreaks breaks{};  ///< where lines through the states are no solid ones
};

/// Of each of this many equal spans of a test, the first and last state, the extremes of q, p′, u
/// and the axial strain and some states at even steps are kept for drawing.
inline constexpr std::int64_t kCurveBuckets = 500;

/// Keeps of each span of the test its first and last state, those with the smallest and largest q,
/// p′, pore pressure and axial strain, and some at even steps, so that a collapse of few seconds is
/// still a curve; in constant memory but for what is kept.
class CurveThinner {
 public:
  /// `scans`: how many states will come; if there are few, all are kept.
  CurveThinner(std::int64_t scans, std::int64_t buckets);
  void add(const lab::State& state);
  /// A state that was added just before and has to be drawn.
  void keep(const lab::State& state);
  /// The states kept, in the order they came. The thinner is empty afterwards.
  std::vector<lab::State> take();

 private:
  void close_bucket();

  std::int64_t span_;
  std::int64_t in_bucket_ = 0;
  std::vector<lab::State> extremes_;  ///< first, last, smallest and largest per quantity, steps
  std::vector<lab::State> kept_;
};

/// The same for points of second-order work, by the extremes of the normalised value.
std::vector<lab::SecondOrderWorkPoint> thin(const std::vector<lab::SecondOrderWorkPoint>& points,
                                            std::int64_t buckets);
/// The same for forecasts, the last of each bucket.
std::vector<lab::Forecast> thin(const std::vector<lab::Forecast>& forecasts, std::int64_t buckets);

}  // namespace triax::study

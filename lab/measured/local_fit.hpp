// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/measured/block_pyramid.hpp"

namespace triax::lab {

/// Least-squares parabolas through the equally spaced blocks of one window, one a signal:
///   y(i) = a + b i + c i²,   i = −3 … 3 counted in blocks from the middle one.
/// The parabola keeps curvature out of the slope, so a peak is not displaced by the window's
/// length. Fitting along the count of readings, and dividing by the rate of progress afterwards,
/// makes uneven, repeated or missing times and strains harmless: only their local rate enters.
struct LocalFit {
  static constexpr double kSlopeFactor = 1.0 / 28;  ///< variance of b per unit variance of a block

  using Values = std::array<double, PathSample::kSignals>;
  PathSample middle;   ///< the middle block itself
  Values value{};      ///< a
  Values slope{};      ///< b, per block
  Values curvature{};  ///< c, per block²
  Values variance{};   ///< of a block about the parabola
};

/// The fit over the window of one level. Pre-condition: pyramid.full(level).
LocalFit fit_window(const BlockPyramid& pyramid, int level);

}  // namespace triax::lab

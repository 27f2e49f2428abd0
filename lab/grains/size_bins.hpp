// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Grains sorted into bins of size, for programs whose contact law knows kinds of grains only.
#include <cstdint>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::lab {

struct SizeBins {
  std::vector<double> radius_m;  ///< that stands for each bin; the bins that hold grains, ascending
  std::vector<std::int32_t> of;  ///< of each grain of state.grains, 0 to radius_m.size() − 1

  /// Error of k_n by bins over that by radii, over all contacts between grains: root of the mean
  /// square, and the largest. 0 without contacts.
  double stiffness_error_rms = 0, stiffness_error_most = 0;
};

/// At most `count` bins of equal width in ln r, each stood for by the geometric mean of its grains'
/// radii. Pre-condition: count ≥ 1.
SizeBins size_bins(const sim::GrainState& state, int count);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "lab/results/reading.hpp"
#include "sim/mechanics/second_order_work.hpp"

namespace triax::lab {

/// Second-order work of the measured path around one reading, from local fits over a window that
/// follows the noise. Work is per unit volume and per square of the unit of the axis: s, or unit of
/// axial strain path where the record has no time. Of time and path one is known, the other NaN.
struct SecondOrderWorkPoint {
  std::int64_t reading = 0;  ///< at the centre of the window
  double time_s = kMissing;
  sim::SecondOrderWork work;
  double normalised_error = 0;       ///< standard error of work.normalised
  std::int64_t window_readings = 0;  ///< readings the fit ran over
  /// Length of the way along ε₁ since the start of shear, both directions counted.
  double axial_strain_path = kMissing;
};

}  // namespace triax::lab

#pragma once
#include <cstdint>

#include "sim/mechanics/second_order_work.hpp"

namespace triax::lab {

/// Second-order work of the measured path around one reading, from local fits over a window that
/// follows the noise. Work is per unit volume and per square of the unit of progress (s, or unit of
/// axial strain path where the record has no time).
struct SecondOrderWorkPoint {
  std::int64_t reading = 0;  ///< at the centre of the window
  double time_s = 0;
  sim::SecondOrderWork work;
  double normalised_error = 0;       ///< standard error of work.normalised
  std::int64_t window_readings = 0;  ///< readings the fit ran over
};

}  // namespace triax::lab

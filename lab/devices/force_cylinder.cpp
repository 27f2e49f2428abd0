// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/force_cylinder.hpp"

#include <numbers>

#include "lab/devices/first_order.hpp"

namespace triax::lab {

double servo_time_constant_s(const LoadingFrame& frame) {
  return frame.bandwidth_hz > 0 ? 1 / (2 * std::numbers::pi * frame.bandwidth_hz) : 0;
}

void advance(const LoadingFrame& frame, ForceCylinderState& state, double wanted_at_start_n,
             double wanted_at_end_n, double dt_s) {
  state.force_n = first_order(state.force_n, wanted_at_start_n, wanted_at_end_n, dt_s,
                              servo_time_constant_s(frame));
}

}  // namespace triax::lab

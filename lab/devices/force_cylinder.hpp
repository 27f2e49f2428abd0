// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/devices/loading_frame.hpp"

namespace triax::lab {

/// The force that the frame's cylinder applies to the piston, above the cell pressure.
struct ForceCylinderState {
  double force_n = 0;
  bool operator==(const ForceCylinderState&) const = default;
};

/// Time constant of the servo, 1/(2π · bandwidth); 0 where it follows at once.
double servo_time_constant_s(const LoadingFrame& frame);

/// The servo follows a wanted force that goes linearly from its value at the start to that at the
/// end of dt: Ḟ = 2π · bandwidth · (F_wanted − F), exactly. Without a bandwidth F = F_wanted at the
/// end, to the bit. Pre-condition: dt_s > 0.
void advance(const LoadingFrame& frame, ForceCylinderState& state, double wanted_at_start_n,
             double wanted_at_end_n, double dt_s);

}  // namespace triax::lab

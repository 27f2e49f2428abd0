// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "lab/results/quantity.hpp"

namespace triax::lab {

/// What the devices of a rig say of themselves, beside the readings. SI.
struct DeviceStates {
  struct Controller {
    double asked_pa = 0;  ///< where the ramp of its set point is
    bool full = false, empty = false;
  };
  Controller cell, back;
  double piston_force_n = 0;  ///< that stands on the cap now, compression +
  /// Whether a raw channel stood at an end of its range at the last look.
  std::array<bool, kRawQuantityCount> saturated{};
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>

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
  std::string fault;          ///< why a device does not do what it is told to; empty: it does
  /// Whether a raw channel stood at an end of its range at the last look.
  std::array<bool, kRawQuantityCount> saturated{};
};

}  // namespace triax::lab

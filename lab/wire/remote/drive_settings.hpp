// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the software demands of its drives, as settings of the points of triax-frame and
// triax-controller.
#include <vector>

#include "lab/rig/demand.hpp"
#include "lab/wire/asking/questions.hpp"

namespace triax::lab {

using DriveSettings = std::vector<PointSetting>;

/// A ramp of force takes the tick's `dt_s`.
DriveSettings frame_settings(const AxisDemand& demand, double dt_s);
DriveSettings pressure_settings(const PressureDemand& demand);
/// Of the back controller, with the valve; the flow of a strain path instead of a pressure.
DriveSettings back_settings(const PlantDemand& demand);
/// A crosshead that stands, whatever drove the axis.
DriveSettings stopped_frame();
DriveSettings held_pressure();

}  // namespace triax::lab

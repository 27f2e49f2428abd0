// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "lab/devices/pressure_controller.hpp"

namespace triax::lab {

/// What is asked of the axis for one tick.
struct AxisDemand {
  enum class Kind { free, crosshead, force };
  Kind kind = Kind::free;
  double velocity_m_per_s = 0;  ///< crosshead
  double spring_n_per_m = 0;    ///< crosshead: of a spring between it and the cap; 0: none
  double start_force_n = 0;     ///< force: wanted at the start of the tick
  double force_n = 0;           ///< force: wanted at its end
  /// force: with an area (as seen at the start), `force_n` is besides a stress on the current one:
  /// a servo that follows the area within the tick.
  double area_m2 = 0, start_stress_pa = 0, stress_pa = 0;
  bool dead = false;       ///< force: masses on the piston, which no servo has to follow
  bool perturbed = false;  ///< with inertia from the start of the tick
  double impulse_n_s = 0;
};

struct PlantDemand {
  AxisDemand axis;
  PressureDemand cell, back;
  /// Volume control of the back controller instead: flow out of the specimen, m³/s.
  std::optional<double> outflow_m3_per_s;
  bool valve_open = true;
};

}  // namespace triax::lab

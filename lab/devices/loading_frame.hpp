// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::lab {

/// A frame that moves the cap at a chosen velocity, with a cylinder for load and dead load
/// (force_cylinder.hpp).
struct LoadingFrame {
  double slowest_m_per_s = 0;  ///< smallest velocity that can be asked for
  double fastest_m_per_s = 0;
  double velocity_step_m_per_s = 0;  ///< its resolution; 0: any velocity
  double stiffness_n_per_m = 0;      ///< crosshead to ram; 0: rigid
  /// Ram to cap; 0: rigid. The displacement transducer stands outside and sees its shortening too.
  double load_cell_stiffness_n_per_m = 0;
  double travel_m = 0;
  double load_limit_n = 0;       ///< emergency stop beyond it, push or pull; 0: none
  double bandwidth_hz = 0;       ///< of the force servo; 0: follows at once
  double servo_filter_s = 0;     ///< over which it smooths the area that it follows; 0: not at all
  double moving_mass_kg = 0;     ///< piston, rod and cap; a dead load's own mass comes on top
  double damping_n_s_per_m = 0;  ///< of the piston in its guide
};

/// Whether the frame can be set to this velocity (of either sign), to the round-off of its unit.
bool gives(const LoadingFrame& frame, double velocity_m_per_s);

/// The velocity that the frame really takes: the nearest whole number of steps, but no less than
/// one step for a velocity that is not 0.
double given_velocity(const LoadingFrame& frame, double velocity_m_per_s);

}  // namespace triax::lab

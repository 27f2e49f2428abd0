#pragma once

namespace triax::lab {

/// A frame that moves the cap at a chosen velocity, or follows a force with a proportional servo
/// (sim::ForceServo) that acts on the true force: its load cell is not the recorded one.
struct LoadingFrame {
  double slowest_m_per_s = 0;  ///< smallest velocity that can be asked for
  double fastest_m_per_s = 0;  ///< also the servo's limit
  double travel_m = 0;
  double servo_gain_m_per_s_per_n = 0;
};

/// Whether the frame can be set to this velocity (of either sign), to the round-off of its unit.
bool gives(const LoadingFrame& frame, double velocity_m_per_s);

}  // namespace triax::lab

#pragma once

namespace triax::lab {

/// A frame that moves the cap at a chosen velocity. It can also follow a force: the servo then asks
/// for a velocity in proportion to the error in force, and the frame gives at most its limit. While
/// the specimen carries the load the error stays small; once it cannot, the frame runs at its
/// limit, the load falls behind and the axial strain runs away. There is no inertia in this
/// run-away.
struct LoadingFrame {
  double slowest_m_per_s = 0;  ///< smallest velocity that can be asked for
  double fastest_m_per_s = 0;
  double travel_m = 0;
  double servo_gain_m_per_s_per_n = 0;
};

/// Velocity of the cap (compression positive) by which the servo follows a force; the servo acts on
/// the true force, its load cell is not the recorded one.
double servo_velocity(const LoadingFrame& frame, double wanted_force_n, double force_n);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/loading_frame.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {

bool gives(const LoadingFrame& frame, double velocity_m_per_s) {
  constexpr double kRoundOff = 1e-9;
  const double speed = std::abs(velocity_m_per_s);
  return speed >= frame.slowest_m_per_s * (1 - kRoundOff) &&
         speed <= frame.fastest_m_per_s * (1 + kRoundOff);
}

double given_velocity(const LoadingFrame& frame, double velocity_m_per_s) {
  const double step = frame.velocity_step_m_per_s;
  if (step == 0 || velocity_m_per_s == 0) return velocity_m_per_s;
  const double steps = std::max(1.0, std::round(std::abs(velocity_m_per_s) / step));
  return std::copysign(steps * step, velocity_m_per_s);
}

}  // namespace triax::lab

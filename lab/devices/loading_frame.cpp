#include "lab/devices/loading_frame.hpp"

#include <algorithm>

namespace triax::lab {

double servo_velocity(const LoadingFrame& frame, double wanted_force_n, double force_n) {
  return std::clamp(frame.servo_gain_m_per_s_per_n * (wanted_force_n - force_n),
                    -frame.fastest_m_per_s, frame.fastest_m_per_s);
}

}  // namespace triax::lab

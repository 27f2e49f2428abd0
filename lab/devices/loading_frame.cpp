#include "lab/devices/loading_frame.hpp"

#include <cmath>

namespace triax::lab {

bool gives(const LoadingFrame& frame, double velocity_m_per_s) {
  constexpr double kRoundOff = 1e-9;
  const double speed = std::abs(velocity_m_per_s);
  return speed >= frame.slowest_m_per_s * (1 - kRoundOff) &&
         speed <= frame.fastest_m_per_s * (1 + kRoundOff);
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/hysteresis.hpp"

#include <algorithm>

namespace triax::lab {

double Hysteresis::follow(double x1, double half_width, double range) {
  if (half_width == 0) return x1;
  double lag = 0;
  double r = 0;
  for (double& play : plays_) {
    r += range / 16;
    play = std::clamp(play, x1 - r, x1 + r);
    lag += x1 - play;
  }
  return x1 - half_width / range * lag;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/boundary_term.hpp"

namespace triax::sim {

double boundary_term(const GrainState& start, const GrainBox& middle, double share,
                     const GrainBox& end) {
  const auto second = [share](double from, double half_way, double to) {
    return 2 * ((to - half_way) / (1 - share) - (half_way - from) / share);
  };
  double sum = 0;
  for (int a = 0; a < 3; ++a)
    sum += start.walls.force_n[2 * a] * second(start.box.low_m[a], middle.low_m[a], end.low_m[a]) -
           start.walls.force_n[2 * a + 1] *
               second(start.box.high_m[a], middle.high_m[a], end.high_m[a]);
  return sum / start.box.volume_m3();
}

}  // namespace triax::sim

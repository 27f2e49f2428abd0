// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/guarded_steps.hpp"

#include <algorithm>
#include <string>

namespace triax::sim {

std::int64_t grains_outside(const GrainState& state) {
  const GrainBox& box = state.box;
  return std::count_if(state.grains.begin(), state.grains.end(), [&](const Grain& g) {
    for (int a = 0; a < 3; ++a)
      if (!(g.position[a] >= box.low_m[a] && g.position[a] <= box.high_m[a])) return true;
    return false;
  });
}

void require_inside(const GrainState& state) {
  const std::int64_t outside = grains_outside(state);
  if (outside > 0)
    throw GrainsFailed(std::to_string(outside) +
                       " grains left the box: walls move too fast or the time step is too long");
}

void advance(Grains& grains, std::int64_t n) {
  if (grains.step(n) != n)
    throw GrainsFailed("a grain flew farther than a radius in one step: the time step is too long");
}

}  // namespace triax::sim

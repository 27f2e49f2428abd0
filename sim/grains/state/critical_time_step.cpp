// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/critical_time_step.hpp"

#include <algorithm>
#include <cmath>

namespace triax::sim {

double critical_time_step(const GrainState& state) {
  const NearPairs& near = state.neighbours.near;
  const double worst_direction = std::max(1.0, 3.5 * state.law.tangential_ratio);
  std::vector<double> stiffness(state.grains.size());
  const auto touches = [&](std::size_t k) {
    const Grain &a = state.grains[near.i[k]], &b = state.grains[near.j[k]];
    return std::hypot(b.position[0] - a.position[0], b.position[1] - a.position[1],
                      b.position[2] - a.position[2]) < near.reach_m[k];
  };
  for (std::size_t k = 0; k < near.size(); ++k) {
    if (!touches(k)) continue;
    stiffness[near.i[k]] += worst_direction * near.stiffness_n_per_m[k];
    stiffness[near.j[k]] += worst_direction * near.stiffness_n_per_m[k];
  }
  for (const auto& at_wall : state.neighbours.near_wall)
    for (const std::int32_t i : at_wall)
      stiffness[i] += wall_stiffness(state.law, state.grains[i].radius);

  double highest = 0;
  std::vector<double> share(state.grains.size());
  for (std::size_t i = 0; i < share.size(); ++i) {
    const Grain& g = state.grains[i];
    const double least = 2 * worst_direction * wall_stiffness(state.law, g.radius);
    share[i] = std::max(stiffness[i], least) * g.inverse_mass;
    highest = std::max(highest, share[i]);
  }
  for (std::size_t k = 0; k < near.size(); ++k)
    if (touches(k)) highest = std::max(highest, share[near.i[k]] + share[near.j[k]]);
  return 2 / std::sqrt(highest);
}

double usual_time_step(const GrainState& state) { return 0.6 * critical_time_step(state); }

}  // namespace triax::sim

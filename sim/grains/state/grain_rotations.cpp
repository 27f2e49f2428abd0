// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_rotations.hpp"

namespace triax::sim {

void GrainRotations::add(const GrainState& state) {
  const double step = state.time_step_s;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const double* spin = state.grains[i].spin;
    turned_[state.ids[i]] += step * Eigen::Vector3d(spin[0], spin[1], spin[2]);
  }
}

}  // namespace triax::sim

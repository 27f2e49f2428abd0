// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far each grain turned over a number of steps. A GrainState holds spins but no orientations,
// as spheres need none; the work at contacts does.
#include <Eigen/Core>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

class GrainRotations {
 public:
  explicit GrainRotations(std::size_t grains) : turned_(grains, Eigen::Vector3d::Zero()) {}

  /// To be called after every step: adds spin × Δt. Turns are summed as vectors, good to the second
  /// order of the turn.
  void add(const GrainState& state);

  /// Rotation vectors, rad, in the order of the description (GrainState::ids).
  const std::vector<Eigen::Vector3d>& turned() const { return turned_; }

 private:
  std::vector<Eigen::Vector3d> turned_;
};

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Steps that are only good if the engine made them and kept every grain in the box.
#include <cstdint>
#include <stdexcept>

#include "sim/grains/engine/grains.hpp"

namespace triax::sim {

/// A run that cannot be trusted: its message, one line, says what happened and what may help.
class GrainsFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Grains whose centre lies beyond a wall.
std::int64_t grains_outside(const GrainState& state);

/// Throws GrainsFailed if a grain lies outside.
void require_inside(const GrainState& state);

/// grains.step(n). Throws GrainsFailed if the engine gave up (a step too long for the stiffness);
/// the state is then the one after that step.
void advance(Grains& grains, std::int64_t n);

}  // namespace triax::sim

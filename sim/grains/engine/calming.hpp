// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Bringing a specimen to rest.
#include <cstdint>

#include "sim/grains/engine/grains.hpp"
#include "sim/grains/state/grain_progress.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::sim {

/// Stops all motion and steps, several times over. Floating grains feel no force, so that damping
/// never stops them; their collisions would drown the small work of a probe. Throws GrainsFailed.
void calm(Grains& grains, int times = 4, std::int64_t steps = 500);

struct Settling {
  double unbalanced = 1e-4;      ///< below this mean resultant over mean contact force (> 0),
  double stress_error_pa = 100;  ///< and with every servo this close to its goal (> 0)
  std::int64_t most_steps = 200000;
  std::int64_t check_every = 500;  ///< steps, > 0
};

struct Settled {
  bool at_rest = false;  ///< false: the bound of steps was reached, or it was stopped
  bool stopped = false;  ///< by the progress
  std::int64_t steps = 0;
  double unbalanced = 0;
  double stress_error_pa = 0;  ///< largest of the stress-driven axes; 0 without one
};

/// How far the servos are from their goals, Pa: the largest of all stress-driven axes.
double stress_error(const GrainState& state);

/// Steps until the specimen is at rest. Throws GrainsFailed, also when a grain lies outside.
Settled settle(Grains& grains, const Settling& settling, const GrainProgress& progress = {});

/// Holds these stresses (axis 1 and both others, Pa, > 0) by servos, settles, calms, and settles
/// again: what a probe may start from. Throws GrainsFailed.
Settled rest(Grains& grains, const AxisymmetricStress& stress, const Settling& settling,
             const GrainProgress& progress = {});

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/calming.hpp"

#include <algorithm>
#include <cmath>

#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "sim/grains/state/walls.hpp"

namespace triax::sim {

void calm(Grains& grains, int times, std::int64_t steps) {
  for (int k = 0; k < times; ++k) {
    grains.stop_motion();
    advance(grains, steps);
  }
}

double stress_error(const GrainState& state) {
  double largest = 0;
  for (int a = 0; a < 3; ++a)
    if (state.walls.drive[a].kind == AxisDrive::Kind::stress)
      largest = std::max(largest, std::abs(conjugate_stress(state.walls, state.box, a) -
                                           state.walls.drive[a].stress_goal_pa));
  return largest;
}

Settled settle(Grains& grains, const Settling& settling, const GrainProgress& progress) {
  Settled result;
  double done = 0;
  while (result.steps < settling.most_steps) {
    const std::int64_t n = std::min(settling.check_every, settling.most_steps - result.steps);
    advance(grains, n);
    result.steps += n;
    require_inside(grains.state());
    result.unbalanced = measure(grains.state()).unbalanced;
    result.stress_error_pa = stress_error(grains.state());
    result.at_rest = result.unbalanced < settling.unbalanced &&
                     result.stress_error_pa < settling.stress_error_pa;
    if (result.at_rest) return result;
    done = std::max(done, std::min(1.0, settling.unbalanced / (result.unbalanced + 1e-300)));
    result.stopped = !goes_on(progress, done, "settling");
    if (result.stopped) return result;
  }
  return result;
}

Settled rest(Grains& grains, const AxisymmetricStress& stress, const Settling& settling,
             const GrainProgress& progress) {
  constexpr double kSpeedLimit = 0.005;  // a specimen at rest needs no more
  grains.drive(triaxial_drives(stress_drive(stress.axial, kSpeedLimit),
                               stress_drive(stress.radial, kSpeedLimit)));
  const Settled first = settle(grains, settling, progress);
  if (!first.at_rest) return first;
  calm(grains);
  Settled second = settle(grains, settling, progress);
  second.steps += first.steps;
  return second;
}

}  // namespace triax::sim

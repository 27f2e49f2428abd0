// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/specimens/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/grains/engine/calming.hpp"
#include "sim/grains/engine/grains.hpp"
#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/state/critical_time_step.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/grains/state/neighbours.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "sim/grains/state/walls.hpp"

namespace triax::sim {
namespace {

constexpr std::int64_t kCheckEvery = 500;

void check(const Compaction& how) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!positive(how.pressure_pa) || !positive(how.wall_speed_m_per_s) ||
      !positive(how.unbalanced) || !positive(how.pressure_share))
    throw std::invalid_argument(
        "compaction: pressure, wall speed, unbalanced limit and fraction must be above 0");
}

bool calm_now(const GrainState& state, const Compaction& how) {
  return stress_error(state) < how.pressure_share * how.pressure_pa &&
         measure(state).unbalanced < how.unbalanced;
}

/// While grains fly, neighbours change fast: wider margins sort less often.
NeighbourMargin loose_margin(const GrainState& state) {
  const auto smaller = [](const Grain& a, const Grain& b) { return a.radius < b.radius; };
  const double r = std::min_element(state.grains.begin(), state.grains.end(), smaller)->radius;
  return {0.6 * r, 0.15 * r};
}

/// Steps until calm or told to stop. Wall speed falls as the pressure comes near by the servo.
void press(Grains& grains, const Compaction& how, const GrainProgress& progress,
           const std::string& what, Compacted& result) {
  const double start = porosity(grains.state());
  double done = 0;
  result.calm = false;
  for (std::int64_t s = 0; s < how.most_steps && !result.calm && !result.stopped;
       s += kCheckEvery) {
    advance(grains, kCheckEvery);
    require_inside(grains.state());
    grains.set_time_step(usual_time_step(grains.state()));
    result.calm = calm_now(grains.state(), how);
    // A packing of spheres stands at a porosity of 0.36 to 0.43.
    const double now = porosity(grains.state());
    done = std::max(done, std::min(0.99, (start - now) / (start - 0.36 + 1e-300)));
    result.stopped = !goes_on(progress, done, what);
  }
}

}  // namespace

Compacted compact(const Cloud& cloud, const ContactLaw& law, const Compaction& how, int threads,
                  const GrainProgress& progress) {
  check(how);
  check(law);
  ContactLaw slippery = law;
  slippery.friction_angle = how.friction_angle;
  Compacted result;
  Grains grains(make_grain_state(cloud.spheres, cloud.box, slippery), threads);
  grains.set_margin(loose_margin(grains.state()));
  const AxisDrive servo = stress_drive(how.pressure_pa, how.wall_speed_m_per_s);
  grains.drive(triaxial_drives(servo, servo));
  press(grains, how, progress, "compressing the cloud", result);
  grains.set_friction_angle(law.friction_angle);
  if (result.calm) press(grains, how, progress, "settling with the friction of the grains", result);
  const GrainState& end = grains.state();
  grains.set_margin(neighbour_margin(
      std::min_element(end.grains.begin(), end.grains.end(), [](const Grain& a, const Grain& b) {
        return a.radius < b.radius;
      })->radius));
  result.porosity = porosity(end);
  result.state = end;
  return result;
}

}  // namespace triax::sim

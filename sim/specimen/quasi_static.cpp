// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/quasi_static.hpp"

#include <algorithm>
#include <cmath>

#include "sim/specimen/step_work.hpp"

namespace triax::sim {
namespace {

/// Share of the travel within which the cap counts as at its stop: round-off of the height.
constexpr double kAtStop = 1e-12;

}  // namespace

SpecimenStep QuasiStatic::driven(const ImplicitStep& by, const SpecimenState& state,
                                 double elapsed_s, double h) const {
  SpecimenStep step = by.take(state, elapsed_s, h);
  const WaterDrive& water = boundary_.water;
  step.work = work_between(
      specimen_, state, step,
      water.back_pressure_pa + water.back_pressure_rate_pa_per_s * (elapsed_s + step.done_s / 2));
  step.state.applied_force_n = specimen_.axial_force(step.state);
  return step;
}

/// The cap goes to its stop, on the side of `way` (+1: compression, -1: extension), and stays
/// there.
SpecimenStep QuasiStatic::to_stop(const SpecimenState& state, double way, double elapsed_s,
                                  double h) const {
  SpecimenBoundary held = boundary_;
  held.axis = {};
  held.axis.kind = AxialDrive::Kind::rigid;
  held.axis.velocity_m_per_s =
      way * std::max(boundary_.axis.travel_m - way * specimen_.displacement_m(state), 0.0) / h;
  SpecimenStep step =
      driven(ImplicitStep(specimen_, held, tolerance_, state.height_m), state, elapsed_s, h);
  step.at_stop = true;
  step.state.applied_force_n = implicit_.applied_force(step.state, elapsed_s + h);
  return step;
}

/// One implicit part.
SpecimenStep QuasiStatic::part(const SpecimenState& state, double elapsed_s, double h) const {
  const AxialDrive& axis = boundary_.axis;
  const bool has_stop = axis.kind == AxialDrive::Kind::force && axis.travel_m > 0;
  const double x = specimen_.displacement_m(state);
  if (has_stop && std::abs(x) >= axis.travel_m * (1 - kAtStop)) {
    const double way = std::copysign(1, x);
    SpecimenStep held = to_stop(state, way, elapsed_s, h);
    const double pressed = held.state.applied_force_n - specimen_.axial_force(held.state);
    if (!went_on(held) || way * pressed >= 0) return held;
  }
  SpecimenStep step = driven(implicit_, state, elapsed_s, h);
  const double then = specimen_.displacement_m(step.state);
  if (has_stop && std::abs(then) > axis.travel_m)
    return to_stop(state, std::copysign(1, then), elapsed_s, h);
  return step;
}

void QuasiStatic::run(SpecimenStep& whole, double dt_s) const {
  const bool resisted = boundary_.water.kind == WaterDrive::Kind::drained &&
                        specimen_.properties().drainage_resistance > 0;
  if (resisted && self_driven_ == nullptr) return run_through_resistance(whole, dt_s);
  const double done = whole.done_s;
  append(whole, part(whole.state, done, dt_s - done));
  if (!went_on(whole)) return;
  whole.done_s = dt_s;
  if (resisted && !whole.at_stop) require_sustained(whole);
}

/// Drainage holds only what is slower than it; the mass does not wait for that.
bool QuasiStatic::require_sustained(SpecimenStep& whole) const {
  const AxialDrive& axis = boundary_.axis;
  const bool can_run_away = axis.kind == AxialDrive::Kind::force && axis.mass_kg > 0;
  if (!can_run_away || implicit_.sustains(whole.state)) return true;
  whole.outcome = StepOutcome::lost_control;
  whole.message = "the equilibrium is unstable against a fast change of force";
  return false;
}

void QuasiStatic::run_through_resistance(SpecimenStep& whole, double dt_s) const {
  const double smallest = 1e-6 * dt_s;
  double h = dt_s;
  while (whole.done_s < dt_s) {
    if (exhausted(whole, tolerance_)) return;
    const double before = whole.done_s;
    const bool last = h >= dt_s - before;
    h = std::min(h, dt_s - before);
    const SpecimenStep full = part(whole.state, before, h);
    SpecimenStep half = part(whole.state, before, h / 2);
    if (went_on(half)) append(half, part(half.state, before + h / 2, h / 2));
    const double error = std::abs(full.state.pore_pressure - half.state.pore_pressure);
    const double allowed = tolerance_.pore_pressure_pa * std::max(h / dt_s, 1e-3);
    const bool good = went_on(full) && went_on(half) && error <= allowed;
    whole.law_steps += full.law_steps;
    if (!good && h > smallest) {
      whole.law_steps += half.law_steps;
      h = std::max(h / 4, smallest);
      continue;
    }
    append(whole, half);
    if (!went_on(half)) return;
    whole.done_s = last ? dt_s : before + h;
    if (!half.at_stop && !require_sustained(whole)) return;
    if (error < allowed / 4) h *= 2;
  }
}

}  // namespace triax::sim

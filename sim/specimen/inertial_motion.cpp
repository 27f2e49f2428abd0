// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/inertial_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/specimen/step_work.hpp"

namespace triax::sim {
namespace {

/// Strain that a substep may make, over its share of √(m/k): 1e-3 at the usual share.
constexpr double kLargestStrain = 0.02;
/// Axial strain since the start below which increments are not compared: integration errors.
constexpr double kSmallestCompared = 1e-7;
/// Times the share that a substep may have had by the stiffness at its end; how often it is
/// quartered for that.
constexpr double kTooLong = 2, kShortest = 1e-4;
/// Substeps that may fail within one step; each is repeated with a quarter of its length.
constexpr int kFailures = 10;
/// Substep (s) where no stiffness can be told.
constexpr double kBlind_s = 1e-6;

double kinetic_energy(const AxialDrive& axis, const SpecimenState& s) {
  return 0.5 * axis.mass_kg * s.velocity_m_per_s * s.velocity_m_per_s;
}

}  // namespace

void InertialMotion::begin(SpecimenState& state, double elapsed_s) const {
  const AxialDrive& axis = boundary_.axis;
  RunAway found;
  found.count = state.run_away.count + 1;
  found.under_way = true;
  found.initial_kinetic_energy_j = found.largest_kinetic_energy_j = kinetic_energy(axis, state);
  found.spring_stiffness_n_per_m = axis.stiffness_n_per_m;
  const auto stress = axisymmetric_stress(state.material.stress);
  found.start_axial_pa = stress.axial;
  found.start_radial_pa = stress.radial;
  found.start_height_m = state.height_m;
  found.start_volume_m3 = specimen_.volume_m3(state);
  found.start_force_n = specimen_.axial_force(state);
  found.start_membrane_pa = specimen_.membrane().axial_pa(state.height_m);
  const double pulls = pull(state, elapsed_s);
  const double direction = state.velocity_m_per_s != 0 ? state.velocity_m_per_s : pulls;
  found.stiffness_at_start_n_per_m = implicit_.stiffness(state, direction) + axis.stiffness_n_per_m;
  // Water that has to flow makes the force one of time, too: no expansion in Δx tells the ratio.
  if (boundary_.water.kind != WaterDrive::Kind::closed &&
      specimen_.properties().drainage_resistance > 0)
    found.stiffness_at_start_n_per_m = std::numeric_limits<double>::quiet_NaN();
  state.run_away = found;
}

/// F_a − F
double InertialMotion::pull(const SpecimenState& state, double elapsed_s) const {
  return implicit_.applied_force(state, elapsed_s) - specimen_.axial_force(state);
}

/// |k| of specimen and spring in the direction of the motion, or of what pulls.
double InertialMotion::stiffness(const SpecimenState& state, double pull_n) const {
  const double v = state.velocity_m_per_s;
  return std::abs(implicit_.stiffness(state, v != 0 ? v : pull_n) +
                  boundary_.axis.stiffness_n_per_m);
}

double InertialMotion::longest_substep(const SpecimenState& state, double pull_n,
                                       double stiffness) const {
  const AxialDrive& axis = boundary_.axis;
  const double share = tolerance_.inertial_substep;
  double h = std::isfinite(stiffness) ? share * std::sqrt(axis.mass_kg / stiffness) : kBlind_s;
  if (axis.damping_n_s_per_m > 0) h = std::min(h, share * axis.mass_kg / axis.damping_n_s_per_m);
  const double far =
      std::abs(state.velocity_m_per_s) * h + 0.5 * std::abs(pull_n) / axis.mass_kg * h * h;
  const double allowed = kLargestStrain * share * state.height_m;
  return far > allowed ? h * allowed / far : h;
}

SpecimenStep InertialMotion::substep(const SpecimenState& state, double elapsed_s, double h) const {
  const AxialDrive& axis = boundary_.axis;
  const double m = axis.mass_kg, c = axis.damping_n_s_per_m;
  const double applied = implicit_.applied_force(state, elapsed_s);
  const double v = state.velocity_m_per_s;
  const double acceleration = (applied - specimen_.axial_force(state) - c * v) / m;
  double half = v + acceleration * h / 2;
  const double way = std::copysign(1, half);  // of the stop ahead, in extension as in compression
  const double left = std::max(axis.travel_m - way * specimen_.displacement_m(state), 0.0);
  const bool stops = axis.travel_m > 0 && half != 0 && way * half * h >= left;
  if (stops && left > 0) {  // up to the stop: v h + a h²/2 = left
    const double ahead = 2 * way * acceleration * left;
    h = std::min(h, 2 * left / (way * v + std::sqrt(std::max(v * v + ahead, 0.0))));
    half = way * left / h;
  } else if (stops) {
    half = 0;
  }

  SpecimenBoundary moving = boundary_;
  moving.axis = {};
  moving.axis.kind = AxialDrive::Kind::rigid;
  moving.axis.velocity_m_per_s = half;
  SpecimenStep step =
      ImplicitStep(specimen_, moving, tolerance_, state.height_m).take(state, elapsed_s, h);
  step.at_stop = stops;
  if (!went_on(step)) return step;

  SpecimenState& end = step.state;
  end.applied_force_n = implicit_.applied_force(end, elapsed_s + h);
  const double pull = end.applied_force_n - specimen_.axial_force(end);
  end.velocity_m_per_s = (half + pull * h / (2 * m)) / (1 + c * h / (2 * m));

  const WaterDrive& water = boundary_.water;
  const double back =
      water.back_pressure_pa + water.back_pressure_rate_pa_per_s * (elapsed_s + h / 2);
  step.work = work_between(specimen_, state, step, back);
  const double moved = state.height_m - end.height_m;
  step.work.axial = 0.5 * (applied + end.applied_force_n) * moved;
  step.work.damping = c * 0.5 * (v + end.velocity_m_per_s) * moved;
  step.work.kinetic = kinetic_energy(axis, end) - kinetic_energy(axis, state);
  return step;
}

/// Takes a substep into the record of the run-away.
void InertialMotion::record(const SpecimenState& before, double elapsed_s,
                            SpecimenStep& step) const {
  RunAway& found = step.state.run_away;
  const double kinetic = kinetic_energy(boundary_.axis, step.state);
  found.elapsed_s += step.done_s;
  if (kinetic > found.largest_kinetic_energy_j) {
    found.largest_kinetic_energy_j = kinetic;
    found.largest_at_s = found.elapsed_s;
  }
  if (before.velocity_m_per_s * step.state.velocity_m_per_s < 0) found.turned = true;
  if (found.compared_at_s > 0) return;
  const double k = boundary_.axis.stiffness_n_per_m;
  const auto without_spring = [&](const SpecimenState& s, double at_s) {
    return implicit_.applied_force(s, at_s) + k * (found.start_height_m - s.height_m) -
           found.start_force_n;
  };
  found.first_order_work_j +=
      0.5 *
      (without_spring(before, elapsed_s) + without_spring(step.state, elapsed_s + step.done_s)) *
      (before.height_m - step.state.height_m);
  found.damping_work_j += step.work.damping;
  compare(step.state);
}

/// Eq. (5), as soon as the second order stands out.
void InertialMotion::compare(SpecimenState& state) const {
  RunAway& found = state.run_away;
  const double volume = specimen_.volume_m3(state);
  const double axial = std::log(found.start_height_m / state.height_m);
  const double volumetric = std::log(found.start_volume_m3 / volume);
  const double radial = 0.5 * (volumetric - axial);
  const auto stress = axisymmetric_stress(state.material.stress);
  const double ds_axial = stress.axial - found.start_axial_pa;
  const double ds_radial = stress.radial - found.start_radial_pa;
  const double dm = specimen_.membrane().axial_pa(state.height_m) - found.start_membrane_pa;
  const double moved = found.start_height_m * axial;
  const double k = found.spring_stiffness_n_per_m;
  const double work = found.start_volume_m3 * (ds_axial * axial + 2 * ds_radial * radial -
                                               ds_radial * volumetric + dm * axial) +
                      found.start_force_n * moved * (axial - volumetric) + k * moved * moved;
  const double first = found.initial_kinetic_energy_j + std::abs(found.first_order_work_j);
  if (std::abs(axial) < kSmallestCompared || !(-work >= 2 * RunAway::kResolved * first)) return;
  found.compared_at_s = found.elapsed_s;
  found.second_order_work_j = work;
  found.kinetic_energy_j = kinetic_energy(boundary_.axis, state);
  const double displaced = found.start_height_m - state.height_m;
  found.secant_stiffness_n_per_m =
      (specimen_.axial_force(state) - found.start_force_n) / displaced + k;
}

/// What a self-driven law may leave of a force, N; a suspension of grains has no p′ to measure by.
double InertialMotion::untold_force(const SpecimenState& state) const {
  if (self_driven_ == nullptr) return 0;
  const DrivingTolerance told = self_driven_->tolerance(state.material);
  return told.loosened * told.stress_pa * specimen_.area_m2(state);
}

bool InertialMotion::at_rest(const SpecimenState& state, double pull_n) const {
  const RunAway& found = state.run_away;
  const double kinetic = kinetic_energy(boundary_.axis, state);
  if (!found.turned && kinetic > kRestShare * found.largest_kinetic_energy_j) return false;
  const double of_p = std::abs(state.material.p()) * specimen_.area_m2(state);
  const double small = kRestForce * of_p;
  if (std::abs(pull_n) >
      std::max(kRestForce * std::max(of_p, std::abs(specimen_.axial_force(state))),
               untold_force(state)))
    return false;
  const double k =
      std::max(std::abs(implicit_.stiffness(state, 1)), std::abs(implicit_.stiffness(state, -1))) +
      boundary_.axis.stiffness_n_per_m;
  if (!(k > 0)) return false;
  const double vibration = kinetic + pull_n * pull_n / (2 * k);
  const double allowed = std::max(kRestShare * found.largest_kinetic_energy_j,
                                  found.turned ? small * small / (2 * k) : 0);
  return vibration <= allowed && implicit_.sustains(state);
}

/// The motion is over; what kinetic energy there was is gone.
void InertialMotion::stop(SpecimenStep& whole) const {
  const double kinetic = kinetic_energy(boundary_.axis, whole.state);
  whole.work.stop += kinetic;
  whole.work.kinetic -= kinetic;
  whole.state.velocity_m_per_s = 0;
  whole.state.run_away.under_way = false;
}

void InertialMotion::run(SpecimenStep& whole, double dt_s) const {
  whole.ran_away = true;
  const double mass = boundary_.axis.mass_kg;
  double shorter = 1;
  int failures = 0;
  double pulls = pull(whole.state, whole.done_s), k = stiffness(whole.state, pulls);
  while (whole.done_s < dt_s && whole.state.run_away.under_way) {
    if (exhausted(whole, tolerance_)) return;
    const SpecimenState& from = whole.state;
    const double longest = shorter * longest_substep(from, pulls, k);
    const double left = dt_s - whole.done_s;
    const bool last = longest >= left;
    SpecimenStep step = substep(from, whole.done_s, last ? left : longest);
    const double pulls_then = pull(step.state, whole.done_s + step.done_s);
    const double k_then = went_on(step) ? stiffness(step.state, pulls_then) : k;
    const bool too_long =
        step.done_s > kTooLong * tolerance_.inertial_substep * std::sqrt(mass / k_then);
    if (went_on(step) ? too_long && shorter > kShortest : failures++ < kFailures) {
      whole.law_steps += step.law_steps;
      shorter /= 4;
      continue;
    }
    shorter = std::min(1.0, 2 * shorter);
    pulls = pulls_then;
    k = k_then;
    if (went_on(step)) record(from, whole.done_s, step);
    const bool reached = last && step.done_s == left;
    append(whole, step);
    if (reached) whole.done_s = dt_s;
    if (!went_on(step)) {
      // Under a displacement there is nothing to lose but the law.
      whole.outcome = StepOutcome::failed;
      whole.law_ended = true;
      return;
    }
    if (step.at_stop) {
      stop(whole);
      whole.state.run_away.end = RunAway::End::end_of_travel;
    } else if (at_rest(whole.state, pulls)) {
      stop(whole);
      whole.state.run_away.end = RunAway::End::arrested;
    }
  }
}

}  // namespace triax::sim

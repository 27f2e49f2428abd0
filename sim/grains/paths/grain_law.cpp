// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/grain_law.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "sim/grains/engine/calming.hpp"
#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/state/critical_time_step.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "sim/law/parameters.hpp"

namespace triax::sim {
namespace {

using Pair = Vector<Axisymmetric>;
using Square = Matrix<Axisymmetric>;
using Control = MixedControl<Axisymmetric>;

/// |Δε| of the increments that the first stiffness is found with, and of one that is tried.
constexpr double kProbeStrain = 1e-6;
/// Share of the elastic determinant below which a prediction is not believed.
constexpr double kDoubtful = 0.01;
/// Share of the first p′ below which the pace falls no further: what has liquefied is no rest.
constexpr double kLeastPaceShare = 0.2;
/// Halvings of the part of an increment that can be met.
constexpr int kHalvings = 3;
/// What a state may differ by from the one that the grains stand at, relative.
constexpr double kSameState = 1e-6;
/// An increment tells of the stiffness if it changes stresses by so many tolerances.
constexpr double kTelling = 5;

/// Share of p′ that a jump of the grains may leave of a stress that goes with a given strain.
constexpr double kTolerableMiss = 0.05;

constexpr const char* kLost = "the control condition cannot be held any longer";

struct Inside : Interior {
  GrainState grains;
  SecantStiffness secant;
};
const Inside& inside(const PointState<Axisymmetric>& state) {
  return static_cast<const Inside&>(*state.interior);
}

std::string percent(double share) { return short_number(100 * share) + " %"; }

/// Empty where the grains can be taken as they stand.
std::string objection_to(const GrainState& grains) {
  if (const auto outside = grains_outside(grains); outside > 0)
    return std::to_string(outside) + " grains lie outside the box";
  const GrainMeasures m = measure(grains);
  const auto& s = m.wall_stress_pa;
  const double p = (s[0] + s[1] + s[2]) / 3;
  if (!(p > 0)) return "the grains carry no stress; compress them first";
  if (!(m.unbalanced <= GrainLaw::kMostUnbalanced))
    return "the grains are not in equilibrium: the mean resultant is " + percent(m.unbalanced) +
           " of the mean contact force, at most " + percent(GrainLaw::kMostUnbalanced) +
           " is allowed; add a hold stage first";
  for (const double stress : s)
    if (!(std::abs(stress - p) <= GrainLaw::kMostOff * p))
      return "the stress is not isotropic: " + short_number(stress / 1e3) + " kPa on one axis, " +
             short_number(p / 1e3) + " kPa in the mean; compress the grains isotropically";
  return {};
}

/// Central differences, so that creep drops out.
Square elastic_stiffness(const GrainState& grains, const StrainPace& pace) {
  Square stiffness;
  const StrainSteps steps = strain_steps(grains, kProbeStrain, pace);
  for (int i = 0; i < 2; ++i) {
    const Pair strain = kProbeStrain * Pair::Unit(i);
    stiffness.col(i) =
        (shoot(grains, strain, steps).stress - shoot(grains, -strain, steps).stress) /
        (2 * kProbeStrain);
  }
  return 0.5 * (stiffness + stiffness.transpose());
}

/// Whether a condition on strain alone asks for something.
bool strains(const PreparedControl<Axisymmetric>& control) {
  for (int row = 0; row < 2; ++row)
    if (control.stress.row(row).isZero(0) && control.increment(row) != 0) return true;
  return false;
}

/// Whether a shot that misses may be taken: the strain that drives it is given, a jump of the
/// grains is all that is in the way.
bool tolerable(const Shot& shot, const PreparedControl<Axisymmetric>& control, double p) {
  return !shot.ran_away && shot.missed_pa <= kTolerableMiss * p && strains(control);
}

int limiting_variable(const PreparedControl<Axisymmetric>& control, const Square& stiffness) {
  const Square matrix = control.stress * stiffness + control.strain;
  return row_that_limits<Axisymmetric>(left_null_vector<Axisymmetric>(matrix), control.increment);
}

}  // namespace

GrainLaw::GrainLaw(const GrainState& state, const GrainDriving& how) : how_(how) {
  if (!(how.inertial_number > 0) || !(how.relative_tolerance > 0) || !(how.least_share > 0))
    throw std::invalid_argument("inertial number, tolerance and least fraction must be above 0");
  if (const std::string why = objection_to(state); !why.empty()) throw std::invalid_argument(why);
  Grains grains(state);
  const AxisDrive rests = strain_rate_drive(0);
  grains.drive(triaxial_drives(rests, rests));
  grains.set_time_step(usual_time_step(state));
  calm(grains);

  const Pair carried = stress_of(grains.state());
  pressure_pa_ = mean_stress<Axisymmetric>(carried);
  start_.stress = carried;
  const ShotLimits limits = this->limits(start_);
  SecantStiffness secant;
  secant.elastic = secant.going_on = elastic_stiffness(grains.state(), limits.pace);
  modulus_pa_ = secant.elastic(0, 0);
  const PreparedControl<Axisymmetric> to_isotropic(
      Control::stresses(sim::isotropic<Axisymmetric>(pressure_pa_) - carried), modulus_pa_);
  const Shot shot = meet(grains.state(), secant, to_isotropic, 1, limits);
  if (!shot.met)
    throw std::invalid_argument(
        "the grains do not reach equilibrium under an isotropic stress of " +
        short_number(pressure_pa_ / 1e3) + " kPa");
  auto found = std::make_shared<Inside>();
  found->grains = shot.grains;
  found->secant = secant;
  start_.stress = stress_of(found->grains);
  start_.void_ratio = measure(found->grains).void_ratio;
  start_.interior = std::move(found);
}

std::int64_t GrainLaw::grains() const {
  return static_cast<std::int64_t>(grains_of(start_).grains.size());
}

GrainLaw::State GrainLaw::start(const Pair& stress, double void_ratio) const {
  const bool same =
      (stress - sim::isotropic<Axisymmetric>(pressure_pa_)).norm() <= kSameState * pressure_pa_ &&
      std::abs(void_ratio - start_.void_ratio) <= kSameState;
  return same ? start_ : State{stress, void_ratio, {}, nullptr};
}

std::optional<std::string> GrainLaw::objection(const State& state) const {
  if (state.interior == nullptr)
    return "the grains are at p' = " + short_number(pressure_pa_ / 1e3) +
           " kPa with e = " + short_number(start_.void_ratio) + "; another state is not possible";
  return Law::objection(state);
}

void GrainLaw::response(const State& state, Response<Axisymmetric>& out) const {
  stiffness_form<Axisymmetric>(out).stiffness = inside(state).secant.going_on;
}

ShotLimits GrainLaw::limits(const State& state) const {
  ShotLimits limits;
  const double p = std::max(state.p(), how_.least_share * pressure_pa_);
  limits.stress_tolerance_pa = how_.relative_tolerance * p;
  limits.pace.inertial_number = how_.inertial_number;
  limits.pace.least_pressure_pa = kLeastPaceShare * pressure_pa_;
  limits.pace.small_stress_pa = limits.stress_tolerance_pa;
  return limits;
}

DrivingTolerance GrainLaw::tolerance(const State& state) const {
  const double stress = limits(state).stress_tolerance_pa;
  return {stress, stress / modulus_pa_, ShotLimits().most_loosened};
}

GrainLaw::State GrainLaw::after(const State& state, const Shot& shot) const {
  const double telling = kTelling * limits(state).stress_tolerance_pa;
  auto found = std::make_shared<Inside>();
  found->secant = inside(state).secant;
  if (modulus_pa_ * shot.strain.norm() > telling)
    found->secant = found->secant.with(shot.strain, shot.stress);
  State next;
  next.stress = stress_of(shot.grains);
  next.void_ratio = (1 + state.void_ratio) * std::exp(-trace<Axisymmetric>(shot.strain)) - 1;
  found->grains = shot.grains;
  next.interior = std::move(found);
  return next;
}

namespace {

/// The largest part of an increment, by halvings, that can be met; `best` is the shot that does.
double halved(const Inside& from, const PreparedControl<Axisymmetric>& control,
              const ShotLimits& limits, int& shots, Shot& best) {
  double reached = 0;
  for (int i = 1; i <= kHalvings; ++i) {
    const double fraction = reached + std::exp2(-i);
    Shot shot = meet(from.grains, from.secant, control, fraction, limits);
    shots += shot.shots;
    if (!shot.met) continue;
    reached = fraction;
    best = std::move(shot);
  }
  return reached;
}

}  // namespace

PointStep<Axisymmetric> GrainLaw::drive(const State& state, const Control& wanted) const {
  PointStep<Axisymmetric> step;
  step.state = state;
  const PreparedControl<Axisymmetric> control(wanted, modulus_pa_);
  if (!control.determined) {
    step.message = "the control conditions do not determine an increment";
    return step;
  }
  step.outcome = StepOutcome::accepted;
  step.done = 1;
  const double tolerance = limits(state).stress_tolerance_pa;
  if (control.increment.norm() <= tolerance && !strains(control)) return step;
  try {
    const Shot shot = taken(state, control, step);
    if (step.done > 0) {
      step.strain_increment = shot.strain;
      step.error = shot.missed_pa / tolerance * how_.relative_tolerance;
      step.state = after(state, shot);
    }
  } catch (const GrainsFailed& failed) {
    step.outcome = StepOutcome::failed;
    step.message = failed.what();
    step.done = 0;
  }
  step.stress_increment = step.state.stress - state.stress;
  return step;
}

/// The shot that the step ends with; says in the step what became of it.
Shot GrainLaw::taken(const State& state, const PreparedControl<Axisymmetric>& control,
                     PointStep<Axisymmetric>& step) const {
  const ShotLimits limits = this->limits(state);
  const Inside& from = inside(state);
  step.steps = 1;
  if (control.strain_driven) {
    const Pair& strain = control.strain_increment;
    return shoot(from.grains, strain, strain_steps(from.grains, strain.norm(), limits.pace));
  }
  Shot shot = meet(from.grains, from.secant, control, 1, limits);
  step.steps = shot.shots;
  if (shot.met) return shot;
  if (tolerable(shot, control, state.p())) {
    step.outcome = StepOutcome::inaccurate;
    step.message = "the grains jumped";
    return shot;
  }
  step.limiting_variable = limiting_variable(control, shot.stiffness);
  step.outcome = StepOutcome::lost_control;
  step.message = kLost;
  step.done = halved(from, control, limits, step.steps, shot);
  return shot;
}

GrainLaw::Rate GrainLaw::rate(const State& state, const Control& wanted) const {
  Rate rate;
  const PreparedControl<Axisymmetric> control(wanted, modulus_pa_);
  if (!control.determined) return rate;
  if (control.increment.isZero(0)) {
    rate.controllable = true;
    return rate;
  }
  const SecantStiffness& secant = inside(state).secant;
  const auto matrix = [&](const Square& k) -> Square {
    return control.stress * k + control.strain;
  };
  Square stiffness = secant.going_on;
  rate.strain = matrix(stiffness).inverse() * control.increment;
  if (rate.strain.dot(secant.direction) < 0) {
    stiffness = secant.elastic;
    rate.strain = matrix(stiffness).inverse() * control.increment;
  }
  rate.determinant = matrix(stiffness).determinant() / matrix(secant.elastic).determinant();
  rate.stress = stiffness * rate.strain;
  rate.controllable = rate.determinant > kDoubtful;
  if (!rate.controllable) rate.limiting_variable = limiting_variable(control, stiffness);
  return rate;
}

bool GrainLaw::sustains(const State& state, const Control& wanted) const {
  if (rate(state, wanted).controllable) return true;
  const PreparedControl<Axisymmetric> control(wanted, modulus_pa_);
  const SecantStiffness& secant = inside(state).secant;
  const Square elastic = control.stress * secant.elastic + control.strain;
  const double fraction = kProbeStrain / Pair(elastic.inverse() * control.increment).norm();
  try {
    return control.determined &&
           meet(inside(state).grains, secant, control, fraction, limits(state)).met;
  } catch (const GrainsFailed&) {
    return false;
  }
}

const GrainState& grains_of(const PointState<Axisymmetric>& state) { return inside(state).grains; }

}  // namespace triax::sim

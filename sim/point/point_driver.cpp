// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/point_driver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/law/on_yield.hpp"
#include "sim/mechanics/linear_algebra.hpp"
#include "sim/point/finite_driver.hpp"
#include "sim/point/self_driven.hpp"

namespace triax::sim {
namespace {

/// Stress ratio by which a step may end outside a yield surface that it did not load: round-off.
constexpr double kOutside = 1e-12;
/// Distance from yield that needs no settling.
constexpr double kSettled = 1e-14;

constexpr const char* kLost = "the control condition cannot be held any longer";

/// Ends a step; false, for the caller to pass on.
template <class Space>
bool end(PointStep<Space>& step, StepOutcome outcome, const std::string& message) {
  step.outcome = outcome;
  step.message = message;
  return false;
}

}  // namespace

template <class Space>
PointDriver<Space>::PointDriver(const Law<Space>& law, const PointState<Space>& reference,
                                const MixedControl<Space>& control, const PointTolerance& tolerance)
    : law_(law),
      tolerance_(tolerance),
      tableau_(tableau_for(tolerance.relative)),
      control_(control, typical_modulus(reference)),
      guess_(Vector<Space>::Zero()),
      flows_(tableau_, law, reference.memory.size()) {
  bend_.fill(guess_);
}

template <class Space>
double PointDriver<Space>::typical_modulus(const PointState<Space>& state) {
  law_.response(state, response_);
  if (const auto* form = std::get_if<StiffnessForm<Space>>(&response_)) {
    mechanisms_ = form->mechanisms;
    return std::max(form->stiffness.diagonal().maxCoeff(), 1e-300);
  }
  return 1 / std::get<InterpolatedForm<Space>>(response_).plus.diagonal().cwiseAbs().mean();
}

/// The mechanisms at whose yield surface the state stands.
template <class Space>
unsigned PointDriver<Space>::on_yield(const PointState<Space>& state) const {
  return mechanisms_on_yield(law_, state, mechanisms_);
}

template <class Space>
PointRate<Space> PointDriver<Space>::respond(const PointState<Space>& state, const Branch& branch) {
  law_.response(state, response_);
  PointRate<Space> rate = solve_control(response_, control_, branch, guess_);
  if (rate.controllable) guess_ = rate.stress;
  return rate;
}

/// At a stage of a step: as far from the first stage as in the step before, unless that is far.
template <class Space>
PointRate<Space> PointDriver<Space>::respond(const PointState<Space>& state, const Branch& branch,
                                             const PointRate<Space>& first, double fraction,
                                             int row) {
  if (!std::holds_alternative<InterpolatedForm<Space>>(response_)) return respond(state, branch);
  Vector<Space>& bend = bend_[static_cast<std::size_t>(row)];
  guess_ = first.stress;
  if (const Vector<Space> turned = fraction * bend;
      turned.squaredNorm() < 0.01 * guess_.squaredNorm())
    guess_ += turned;
  PointRate<Space> rate = respond(state, branch);
  if (rate.controllable) bend = (rate.stress - first.stress) / fraction;
  return rate;
}

/// Finds the mechanisms at whose yield surface the state stands, and settles it there. What a step
/// has settled already (the only mechanism at a distance of round-off) is left as it is.
template <class Space>
void PointDriver<Space>::settle(PointState<Space>& state) {
  if (mechanisms_ == 1) {
    const double distance = law_.yield_distance(state, 0);
    standing_ = distance >= -kOnYield ? 1U : 0U;
    if (std::abs(distance) > kSettled) law_.settle(state, standing_);
    return;
  }
  standing_ = on_yield(state);
  law_.settle(state, standing_);
  if (mechanisms_ > 1) standing_ = on_yield(state);  // settling may name the mechanisms anew
}

/// Rate at the start of a step, after settling; `state` may be changed by that.
template <class Space>
PointRate<Space> PointDriver<Space>::begin(PointState<Space>& state) {
  settle(state);
  PointRate<Space> rate = respond(state, {standing_, std::nullopt});
  if (rate.controllable && law_.turn(state, rate)) rate = respond(state, {standing_, {}});
  return rate;
}

template <class Space>
void PointDriver<Space>::flow_of(const PointState<Space>& at, const PointRate<Space>& rate,
                                 StageFlow<Space>& flow) const {
  flow.stress = rate.stress;
  flow.strain = rate.strain;
  flow.void_ratio = -(1 + at.void_ratio) * trace<Space>(rate.strain);
  if (at.memory.size() == 0) return;
  flow.memory.resize(at.memory.size());
  law_.memory_rate(at, response_, rate, flow.memory);
}

/// One Runge-Kutta step over `fraction` of the increment on the branch that `first` is on.
template <class Space>
void PointDriver<Space>::runge_kutta(const PointState<Space>& from, const PointRate<Space>& first,
                                     double fraction, Trial& trial) {
  trial.possible = trial.lost_control = trial.refused = false;
  const Branch branch{standing_, first.active};
  const PointState<Space>& at = trial.state;
  for (int row = 1; row < tableau_.rows; ++row) {
    flows_.move(from, fraction, row, trial.state, trial.strain);
    if (!std::isfinite(at.stress.sum()) || (!law_.carries_tension() && !(at.p() > 0))) return;
    if (row >= tableau_.evaluations) break;
    const PointRate<Space> rate = respond(at, branch, first, fraction, row);
    if (!rate.controllable) {
      trial.lost_control = rate.limiting_variable >= 0;
      trial.limiting_variable = rate.limiting_variable;
      return;
    }
    if (!keeps_branch(at, rate)) return;
    flow_of(at, rate, flows_[row]);
  }
  trial.error = flows_.error_at(at, fraction);
  trial.refused = law_.objection(at).has_value();
  trial.possible = std::isfinite(trial.error) && !trial.refused;
}

/// A stage belongs to another branch if a loading mechanism unloads or one that stands on its
/// surface, unloading at the start, would load.
template <class Space>
bool PointDriver<Space>::keeps_branch(const PointState<Space>& at,
                                      const PointRate<Space>& rate) const {
  if (!consistent(rate)) return false;
  const unsigned idle = standing_ & ~rate.active;
  if (idle == 0) return true;
  const auto& form = std::get<StiffnessForm<Space>>(response_);
  for (int k = 0; k < mechanisms_; ++k) {
    if (!(idle >> k & 1U) || law_.yield_distance(at, k) < -kOnYield) continue;
    const auto& trigger = form.trigger[static_cast<std::size_t>(k)];
    double push = trigger.dot(rate.strain);
    for (int j = 0; j < mechanisms_; ++j)
      push -= form.hardening(k, j) * rate.multiplier[static_cast<std::size_t>(j)];
    if (push > 1e-9 * trigger.norm() * rate.strain.norm()) return false;
  }
  return true;
}

/// Whether a mechanism that does not load in this step has come outside its surface, or one that
/// loads (or a law without mechanisms) has reversed.
template <class Space>
bool PointDriver<Space>::crossed(const PointState<Space>& state, unsigned active) const {
  for (int k = 0; k < mechanisms_; ++k)
    if (!(active >> k & 1U) && law_.yield_distance(state, k) > kOutside) return true;
  return (active != 0 || mechanisms_ == 0) && law_.reversal(state) < -kOutside;
}

/// Shortens a step that came through a yield surface or a reversal to end there; `fraction` is what
/// it covers.
template <class Space>
void PointDriver<Space>::stop_at_crossing(const PointState<Space>& from,
                                          const PointRate<Space>& first, double& fraction,
                                          Trial& trial) {
  double low = 0, high = fraction;
  Trial shorter;
  for (int i = 0; i < 200 && high - low > 1e-15 * fraction; ++i) {
    const double middle = 0.5 * (low + high);
    runge_kutta(from, first, middle, shorter);
    if (shorter.possible && !crossed(shorter.state, first.active)) {
      low = middle;
      continue;
    }
    high = middle;
    if (shorter.possible) trial = shorter;
  }
  fraction = high;
}

/// The step without any loading mechanism.
template <class Space>
bool PointDriver<Space>::take_idle(const PointState<Space>& from, double fraction, Trial& trial) {
  standing_ = 0;
  const PointRate<Space> rate = respond(from, {0, 0U});
  if (!rate.controllable) return false;
  flow_of(from, rate, flows_[0]);
  runge_kutta(from, rate, fraction, trial);
  return trial.possible;
}

/// Tries a step of `fraction`. False: it was shortened, or (outcome changed) there is none.
template <class Space>
bool PointDriver<Space>::attempt(const PointState<Space>& from, const PointRate<Space>& start,
                                 double& fraction, PointStep<Space>& step) {
  runge_kutta(from, start, fraction, trial_);
  const double wanted = tolerance_.relative;
  if (trial_.possible && trial_.error <= wanted) return true;
  if (fraction > tolerance_.smallest_step) {
    const double shrink =
        trial_.possible ? 0.9 * std::pow(wanted / trial_.error, 1.0 / tableau_.order) : 0.25;
    fraction = std::max(fraction * std::clamp(shrink, 0.1, 0.9), 0.5 * tolerance_.smallest_step);
    return false;
  }
  if (trial_.possible) return true;
  if (trial_.lost_control) {
    step.limiting_variable = trial_.limiting_variable;
    return end(step, StepOutcome::lost_control, kLost);
  }
  if (!control_.strain_driven && law_.at_limit(trial_.state)) {
    blame(from, start.strain, step);
    // A strain can be held at a limit of stress; that the law ends there is no loss of control.
    if (control_.strain.row(step.limiting_variable).isZero(0))
      return end(step, StepOutcome::lost_control, kLost);
    step.limiting_variable = -1;
  }
  // The branch changes within this smallest step: take it without loading.
  if (!trial_.refused && take_idle(from, fraction, trial_)) return true;
  const auto objection = law_.objection(trial_.state);
  return end(step, StepOutcome::failed,
             objection.value_or("no admissible state within reach of the increment"));
}

/// Names the condition that drives the strain along `direction`: dε = C A⁻¹ dy with A = S + E C.
template <class Space>
void PointDriver<Space>::blame(const PointState<Space>& at, const Vector<Space>& direction,
                               PointStep<Space>& step) {
  law_.response(at, response_);
  const auto* form = std::get_if<StiffnessForm<Space>>(&response_);
  const Matrix<Space> compliance =
      form != nullptr ? inverse<Space>(form->stiffness)
                      : Matrix<Space>(std::get<InterpolatedForm<Space>>(response_).plus);
  const Matrix<Space> a = (control_.stress + control_.strain * compliance).transpose();
  step.limiting_variable = row_that_limits<Space>(
      solve<Space>(a, compliance.transpose() * direction), control_.increment);
}

/// Whether a strain that nothing holds has grown without end; the condition to blame is then the
/// one that drives it.
template <class Space>
bool PointDriver<Space>::ran_away(const PointState<Space>& from, PointStep<Space>& step) {
  if (control_.strain_driven || step.strain_increment.norm() < tolerance_.runaway_strain)
    return false;
  double asked = 0;  // strain that the conditions themselves give
  for (int row = 0; row < Space::kSize; ++row)
    if (const double size = control_.strain.row(row).norm(); size > 0)
      asked = std::max(asked, std::abs(control_.increment(row)) / size);
  if (step.strain_increment.norm() < 10 * asked) return false;
  blame(from, step.strain_increment, step);
  end(step, StepOutcome::lost_control,
      "runaway of the strain: the control condition cannot be held any longer");
  return true;
}

/// Takes the tried step and proposes the size of the next.
template <class Space>
void PointDriver<Space>::take(const PointRate<Space>& start, double& fraction,
                              PointStep<Space>& step) {
  double covered = fraction;
  const bool met = crossed(trial_.state, start.active);
  if (met) stop_at_crossing(step.state, start, covered, trial_);
  step.error = std::max(step.error, trial_.error);
  step.state = trial_.state;
  if (met) law_.settle(step.state, start.active | on_yield(step.state));
  if (!met && start.active != 0) law_.settle(step.state, start.active);
  step.strain_increment += trial_.strain;
  step.done = covered >= 1 - step.done ? 1 : step.done + covered;
  if (step.done == 1) return;
  const double grow = trial_.error > 0
                          ? 0.9 * std::pow(tolerance_.relative / trial_.error, 1.0 / tableau_.order)
                          : 5;
  fraction = std::max(fraction * std::clamp(grow, 0.2, 5.0), tolerance_.smallest_step);
}

template <class Space>
PointStep<Space> PointDriver<Space>::advance(const PointState<Space>& state) {
  PointStep<Space> step;
  step.state = state;
  step.outcome = StepOutcome::accepted;
  double fraction = 1;
  PointState<Space>& from = step.state;
  while (step.done < 1) {
    const PointRate<Space> start = begin(from);
    if (!start.controllable) {
      step.limiting_variable = start.limiting_variable;
      if (start.limiting_variable >= 0)
        end(step, StepOutcome::lost_control, kLost);
      else
        end(step, StepOutcome::failed, "the control conditions do not determine an increment");
      break;
    }
    if (auto refusal = law_.refusal(from, start)) {
      end(step, StepOutcome::failed, std::move(*refusal));
      break;
    }
    flow_of(from, start, flows_[0]);
    bool found = false;
    while (!found && step.outcome == StepOutcome::accepted) {
      if (++step.steps > tolerance_.step_limit) {
        end(step, StepOutcome::failed, "more integration steps than the limit allows");
        break;
      }
      fraction = std::min(fraction, 1 - step.done);
      found = attempt(from, start, fraction, step);
    }
    if (!found) break;
    take(start, fraction, step);
    if (step.done < 1 && ran_away(step.state, step)) break;
  }
  if (step.outcome == StepOutcome::accepted && step.error > tolerance_.relative)
    end(step, StepOutcome::inaccurate, "the integration error exceeds the tolerance");
  step.stress_increment = step.state.stress - state.stress;
  return step;
}

template <class Space>
PointRate<Space> point_rate(const Law<Space>& law, const PointState<Space>& state,
                            const MixedControl<Space>& control) {
  if (law.finite()) return finite_rate(law, state, control);
  if (const auto* own = law.self_driven()) return own->rate(state, control);
  const PointTolerance tolerance;
  return PointDriver<Space>(law, state, control, tolerance).rate(state);
}

template <class Space>
PointStep<Space> advance_point(const Law<Space>& law, const PointState<Space>& state,
                               const MixedControl<Space>& control,
                               const PointTolerance& tolerance) {
  if (auto objection = law.objection(state)) {
    PointStep<Space> refused;
    refused.state = state;
    refused.message = *objection;
    return refused;
  }
  if (law.finite()) return advance_finite(law, state, control, tolerance);
  if (const auto* own = law.self_driven()) return own->drive(state, control);
  return PointDriver<Space>(law, state, control, tolerance).advance(state);
}

template class PointDriver<Axisymmetric>;
template class PointDriver<Tensor>;
template PointRate<Axisymmetric> point_rate(const Law<Axisymmetric>&,
                                            const PointState<Axisymmetric>&,
                                            const MixedControl<Axisymmetric>&);
template PointRate<Tensor> point_rate(const Law<Tensor>&, const PointState<Tensor>&,
                                      const MixedControl<Tensor>&);
template PointStep<Axisymmetric> advance_point(const Law<Axisymmetric>&,
                                               const PointState<Axisymmetric>&,
                                               const MixedControl<Axisymmetric>&,
                                               const PointTolerance&);
template PointStep<Tensor> advance_point(const Law<Tensor>&, const PointState<Tensor>&,
                                         const MixedControl<Tensor>&, const PointTolerance&);

}  // namespace triax::sim

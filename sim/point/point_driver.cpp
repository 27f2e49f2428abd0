#include "sim/point/point_driver.hpp"

#include <algorithm>
#include <cmath>

#include "sim/point/control_solver.hpp"
#include "sim/point/finite_driver.hpp"
#include "sim/point/runge_kutta.hpp"

namespace triax::sim {
namespace {

/// Stress ratio by which an elastic step may end outside a yield surface: round-off.
constexpr double kOutside = 1e-12;
/// Tolerances from here on are met more cheaply by the pair of low order.
constexpr double kModerateTolerance = 1e-7;

template <class Space>
struct Flow {  // the derivative of everything that is integrated
  Vector<Space> stress, strain;
  double void_ratio = 0;
  Memory memory;
};

template <class Space>
class Driver {
 public:
  Driver(const Law<Space>& law, const PointState<Space>& state, const MixedControl<Space>& control,
         const PointTolerance& tolerance)
      : law_(law),
        tolerance_(tolerance),
        tableau_(tolerance.relative < kModerateTolerance ? kDormandPrince : kBogackiShampine),
        control_(control, typical_modulus(state)),
        guess_(Vector<Space>::Zero()) {
    for (int k = 0; k < state.memory.size(); ++k) {
      scale_.resize(state.memory.size());
      scale_(k) = law.memory_scale(k);
    }
  }

  /// The mechanisms at whose yield surface the state stands.
  unsigned on_yield(const PointState<Space>& state) const {
    unsigned set = 0;
    for (int k = 0; k < mechanisms_; ++k)
      if (law_.yield_distance(state, k) >= -kOnYield) set |= 1U << k;
    return set;
  }

  /// Rate at the start of a step, after settling; `state` may be changed by that.
  PointRate<Space> begin(PointState<Space>& state) {
    standing_ = on_yield(state);
    law_.settle(state, standing_);
    PointRate<Space> rate = respond(state, {standing_, std::nullopt});
    if (rate.controllable && law_.turn(state, rate)) rate = respond(state, {standing_, {}});
    if (rate.controllable) guess_ = rate.stress;
    return rate;
  }

  struct Trial {
    bool possible = false;      ///< every stage had a meaning and kept the branch
    bool lost_control = false;  ///< a stage could not meet the conditions
    int culprit = -1;
    PointState<Space> state;
    Vector<Space> strain;
    double error = 0;
  };

  /// One Runge-Kutta step over `fraction` of the increment on the branch that `first` is on.
  void runge_kutta(const PointState<Space>& from, const PointRate<Space>& first, double fraction,
                   Trial& trial) {
    trial.possible = trial.lost_control = false;
    const Branch branch{standing_, first.active};
    flow_of(from, first, flows_[0]);
    PointState<Space>& at = trial.state;
    for (int i = 1; i < tableau_.stages; ++i) {
      const auto& a = tableau_.a[static_cast<std::size_t>(i)];
      at = from;
      trial.strain.setZero();
      for (int j = 0; j < i; ++j) {
        const double weight = fraction * a[static_cast<std::size_t>(j)];
        if (weight == 0) continue;
        const Flow<Space>& flow = flows_[static_cast<std::size_t>(j)];
        at.stress += weight * flow.stress;
        at.void_ratio += weight * flow.void_ratio;
        if (at.memory.size() > 0) at.memory += weight * flow.memory;
        trial.strain += weight * flow.strain;
      }
      if (!std::isfinite(at.stress.sum()) || (!law_.carries_tension() && !(at.p() > 0))) return;
      const PointRate<Space> rate = respond(at, branch);
      if (!rate.controllable) {
        trial.lost_control = rate.culprit >= 0;
        trial.culprit = rate.culprit;
        return;
      }
      if (!keeps_branch(at, rate)) return;
      flow_of(at, rate, flows_[static_cast<std::size_t>(i)]);
    }
    trial.error = error_of(at, fraction);
    trial.possible = std::isfinite(trial.error) && !law_.objection(at);
  }

  /// Bit k: the mechanism, not loading in this step, has come outside its surface.
  bool crossed(const PointState<Space>& state, unsigned active) const {
    for (int k = 0; k < mechanisms_; ++k)
      if (!(active >> k & 1U) && law_.yield_distance(state, k) > kOutside) return true;
    return false;
  }

  /// Shortens a step that came through a yield surface to end on it. `fraction` is what it covers.
  void stop_at_yield(const PointState<Space>& from, const PointRate<Space>& first, double& fraction,
                     Trial& trial) {
    double low = 0, high = fraction;
    Trial shorter;
    for (int i = 0; i < 200 && high - low > 1e-15 * fraction; ++i) {
      const double middle = 0.5 * (low + high);
      runge_kutta(from, first, middle, shorter);
      if (!shorter.possible || crossed(shorter.state, first.active)) {
        high = middle;
        if (shorter.possible) trial = shorter;
      } else {
        low = middle;
      }
    }
    fraction = high;
  }

  /// The step without any loading mechanism.
  bool take_idle(const PointState<Space>& from, double fraction, Trial& trial) {
    standing_ = 0;
    const PointRate<Space> rate = respond(from, {0, 0U});
    if (rate.controllable) runge_kutta(from, rate, fraction, trial);
    return rate.controllable && trial.possible;
  }

  const Law<Space>& law_;
  const PointTolerance& tolerance_;
  const Tableau& tableau_;

 private:
  double typical_modulus(const PointState<Space>& state) {
    law_.response(state, response_);
    if (const auto* form = std::get_if<StiffnessForm<Space>>(&response_)) {
      mechanisms_ = form->mechanisms;
      return std::max(form->stiffness.diagonal().maxCoeff(), 1e-300);
    }
    return 1 / std::get<InterpolatedForm<Space>>(response_).plus.diagonal().cwiseAbs().mean();
  }

  PointRate<Space> respond(const PointState<Space>& state, const Branch& branch) {
    law_.response(state, response_);
    return solve_control(response_, control_, branch, guess_);
  }

  /// A stage belongs to another branch if a loading mechanism unloads or one that stands on its
  /// surface, unloading at the start, would load.
  bool keeps_branch(const PointState<Space>& at, const PointRate<Space>& rate) const {
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

  void flow_of(const PointState<Space>& at, const PointRate<Space>& rate, Flow<Space>& flow) const {
    flow.stress = rate.stress;
    flow.strain = rate.strain;
    flow.void_ratio = -(1 + at.void_ratio) * trace<Space>(rate.strain);
    if (at.memory.size() == 0) return;
    flow.memory.resize(at.memory.size());
    law_.memory_rate(at, response_, rate, flow.memory);
  }

  double error_of(const PointState<Space>& at, double fraction) const {
    Vector<Space> stress = Vector<Space>::Zero();
    double void_ratio = 0, worst = 0;
    for (int i = 0; i < tableau_.stages; ++i) {
      const double weight = fraction * tableau_.error[static_cast<std::size_t>(i)];
      stress += weight * flows_[static_cast<std::size_t>(i)].stress;
      void_ratio += weight * flows_[static_cast<std::size_t>(i)].void_ratio;
    }
    for (int k = 0; k < at.memory.size(); ++k) {
      double sum = 0;
      for (int i = 0; i < tableau_.stages; ++i)
        sum += tableau_.error[static_cast<std::size_t>(i)] *
               flows_[static_cast<std::size_t>(i)].memory(k);
      worst = std::max(worst, std::abs(fraction * sum) / scale_(k));
    }
    const double size = std::max(std::abs(at.p()), 0.1);  // Pa
    return std::max({worst, stress.cwiseAbs().maxCoeff() / size, std::abs(void_ratio)});
  }

  int mechanisms_ = 0;
  unsigned standing_ = 0;
  Response<Space> response_;
  PreparedControl<Space> control_;
  Vector<Space> guess_;
  Memory scale_;
  std::array<Flow<Space>, Tableau::kMostStages> flows_;
};

constexpr const char* kLost = "the control condition cannot be held any longer";

}  // namespace

template <class Space>
PointRate<Space> point_rate(const Law<Space>& law, const PointState<Space>& state,
                            const MixedControl<Space>& control) {
  if (law.finite()) return finite_rate(law, state, control);
  Driver<Space> driver(law, state, control, {});
  PointState<Space> settled = state;
  return driver.begin(settled);
}

template <class Space>
PointStep<Space> advance_point(const Law<Space>& law, const PointState<Space>& state,
                               const MixedControl<Space>& control,
                               const PointTolerance& tolerance) {
  PointStep<Space> step;
  step.state = state;
  const auto finish = [&step](StepOutcome outcome, const char* message) {
    step.outcome = outcome;
    step.message = message;
  };
  if (auto objection = law.objection(state)) {
    step.message = *objection;
    return step;
  }
  if (law.finite()) return advance_finite(law, state, control, tolerance);
  Driver<Space> driver(law, state, control, tolerance);
  step.outcome = StepOutcome::accepted;
  typename Driver<Space>::Trial trial;
  const double power = 1.0 / driver.tableau_.order;
  double fraction = 1;
  bool again = false;  // the same state as before, with a smaller step
  PointState<Space> from;
  PointRate<Space> start;
  while (step.done < 1) {
    if (++step.steps > tolerance.step_limit) {
      finish(StepOutcome::failed, "more integration steps than the limit allows");
      break;
    }
    fraction = std::min(fraction, 1 - step.done);
    if (!again) {
      from = step.state;
      start = driver.begin(from);
    }
    again = true;
    if (!start.controllable) {
      step.culprit = start.culprit;
      if (start.culprit < 0)
        finish(StepOutcome::failed, "the control conditions do not determine an increment");
      else
        finish(StepOutcome::lost_control, kLost);
      break;
    }
    driver.runge_kutta(from, start, fraction, trial);
    if (!trial.possible || trial.error > tolerance.relative) {
      if (fraction > tolerance.smallest_step) {
        const double shrink =
            trial.possible ? 0.9 * std::pow(tolerance.relative / trial.error, power) : 0.25;
        fraction = std::max(fraction * std::clamp(shrink, 0.1, 0.9), 0.5 * tolerance.smallest_step);
        continue;
      }
      if (trial.lost_control) {
        step.culprit = trial.culprit;
        finish(StepOutcome::lost_control, kLost);
        break;
      }
      if (!trial.possible) {
        // The branch changes within this smallest step: take it without loading.
        if (!driver.take_idle(from, fraction, trial)) {
          finish(StepOutcome::failed, "no admissible state within reach of the increment");
          break;
        }
      }
    }
    double covered = fraction;
    if (driver.crossed(trial.state, start.active))
      driver.stop_at_yield(from, start, covered, trial);
    again = false;
    step.error = std::max(step.error, trial.error);
    step.state = trial.state;
    if (start.active != 0) law.settle(step.state, start.active);
    step.strain_increment += trial.strain;
    step.done = covered >= 1 - step.done ? 1 : step.done + covered;
    const double grow =
        trial.error > 0 ? 0.9 * std::pow(tolerance.relative / trial.error, power) : 5;
    fraction = std::max(fraction * std::clamp(grow, 0.2, 5.0), tolerance.smallest_step);
  }
  if (step.outcome == StepOutcome::accepted && step.error > tolerance.relative)
    finish(StepOutcome::inaccurate, "the integration error exceeds the tolerance");
  step.stress_increment = step.state.stress - state.stress;
  return step;
}

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

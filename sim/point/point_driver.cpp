#include "sim/point/point_driver.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace triax::sim {
namespace {

/// The control in (p′, q), (ε_v, ε_q), each row scaled to order one in stress.
struct InvariantControl {
  Eigen::Matrix2d stress, strain;
  Eigen::Vector2d increment;
};

InvariantControl in_invariants(const MixedControl& control, double modulus) {
  Eigen::Matrix2d stress_of, strain_of;
  stress_of << 1, 2.0 / 3, 1, -1.0 / 3;    // (σ₁, σ₃) of (p, q)
  strain_of << 1.0 / 3, 1, 1.0 / 3, -0.5;  // (ε₁, ε₃) of (ε_v, ε_q)
  InvariantControl c{control.stress * stress_of, control.strain * strain_of, control.increment};
  for (int row = 0; row < 2; ++row) {
    const double size =
        c.stress.row(row).cwiseAbs().maxCoeff() + c.strain.row(row).cwiseAbs().maxCoeff() / modulus;
    if (size <= 0) continue;
    c.stress.row(row) /= size;
    c.strain.row(row) /= size;
    c.increment(row) /= size;
  }
  return c;
}

/// Row with the largest weight in the left null vector of the singular matrix (adjugate).
int culprit_row(const Eigen::Matrix2d& m) {
  const double weight_0 = std::max(std::abs(m(1, 0)), std::abs(m(1, 1)));
  const double weight_1 = std::max(std::abs(m(0, 0)), std::abs(m(0, 1)));
  return weight_0 >= weight_1 ? 0 : 1;
}

AxisymmetricStress principal_stress(const Eigen::Vector2d& s) {
  return {s(0) + 2 * s(1) / 3, s(0) - s(1) / 3};
}
AxisymmetricStrain principal_strain(const Eigen::Vector2d& e) {
  return {e(0) / 3 + e(1), e(0) / 3 - e(1) / 2};
}

// Dormand and Prince (1980), the 5th-order method with its embedded 4th-order one.
constexpr int kStages = 7;
constexpr std::array<std::array<double, 6>, kStages> kA{{
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
}};
constexpr std::array<double, kStages> kError{
    71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

/// Stress ratio by which an elastic step may stand outside the yield surface: round-off.
constexpr double kOutside = 1e-12;

template <class Law>
struct Trial {
  bool possible = false;      ///< every stage had a meaning and kept the branch
  bool lost_control = false;  ///< a stage could not meet the conditions
  int culprit = -1;
  typename Law::State state;
  Eigen::Vector2d strain = Eigen::Vector2d::Zero();
  double error = 0;
};

PointRate solve(const ElastoplasticTangent& t, const MixedControl& control, bool may_yield,
                bool must_yield) {
  const InvariantControl c = in_invariants(control, t.elastic(1, 1));
  PointRate r;
  const Eigen::Matrix2d a = c.stress * t.elastic + c.strain;
  const double det = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  const double size = a.row(0).norm() * a.row(1).norm();
  if (!(std::abs(det) > 1e-12 * size)) return r;
  Eigen::Matrix2d inverse;
  inverse << a(1, 1), -a(0, 1), -a(1, 0), a(0, 0);
  inverse /= det;

  const Eigen::Vector2d elastic_strain = inverse * c.increment;
  const Eigen::Vector2d n_c = t.elastic.transpose() * t.normal;
  const double trial = n_c.dot(elastic_strain);
  double lambda = 0;
  if ((may_yield && trial > 0) || must_yield) {
    const Eigen::Vector2d c_r = t.elastic * t.flow;
    const double denominator =
        t.hardening + t.normal.dot(c_r) - n_c.dot(inverse * (c.stress * c_r));
    const double scale = std::abs(t.hardening) + std::abs(t.normal.dot(c_r));
    if (!(denominator > 1e-12 * scale)) {
      const Eigen::Matrix2d plastic =
          t.elastic - c_r * n_c.transpose() / (t.hardening + t.normal.dot(c_r));
      r.culprit = culprit_row(c.stress * plastic + c.strain);
      return r;
    }
    lambda = trial / denominator;
    r.plastic = true;
    r.strain = inverse * (c.increment + c.stress * c_r * lambda);
  } else {
    r.strain = elastic_strain;
  }
  r.multiplier = lambda;
  r.plastic_strain = lambda * t.flow;
  r.stress = t.elastic * (r.strain - r.plastic_strain);
  r.controllable = r.stress.allFinite() && r.strain.allFinite();
  return r;
}

/// One Runge-Kutta step over `fraction` of the increment on a fixed branch.
template <class Law>
Trial<Law> runge_kutta(const Law& law, const typename Law::State& from, const MixedControl& control,
                       double fraction, bool plastic) {
  Trial<Law> trial;
  std::array<typename Law::Rate, kStages> rates;
  std::array<Eigen::Vector2d, kStages> strains;
  typename Law::State at = from;
  for (std::size_t i = 0; i < kStages; ++i) {
    typename Law::Rate sum;
    trial.strain.setZero();
    for (std::size_t j = 0; j < i; ++j) {
      if (kA[i][j] == 0) continue;
      sum = sum + (fraction * kA[i][j]) * rates[j];
      trial.strain += fraction * kA[i][j] * strains[j];
    }
    if (i > 0) at = law.moved(from, sum, plastic);
    if (!(at.p > 0)) return trial;
    const PointRate r = solve(law.tangent(at), control, plastic, plastic);
    if (!r.controllable) {
      trial.lost_control = r.culprit >= 0;
      trial.culprit = r.culprit;
      return trial;
    }
    // A plastic stage that unloads belongs to the other branch.
    if (plastic && i > 0 && r.multiplier < 0) return trial;
    rates[i] = law.rate(at, r.stress, r.strain, r.plastic_strain);
    strains[i] = r.strain;
  }
  typename Law::Rate error;
  for (std::size_t i = 0; i < kStages; ++i) error = error + (fraction * kError[i]) * rates[i];
  trial.state = at;  // the last stage is the 5th-order result
  trial.error = law.error_measure(error, at);
  trial.possible = std::isfinite(trial.error) && !law.objection(at);
  return trial;
}

/// Shortens an elastic step that left the elastic region so that it ends on its border.
template <class Law>
Trial<Law> to_yield(const Law& law, const typename Law::State& from, const MixedControl& control,
                    double& fraction) {
  double inside = 0, outside = fraction;
  Trial<Law> best = runge_kutta(law, from, control, outside, false);
  for (int i = 0; i < 100 && outside - inside > 1e-15 * fraction; ++i) {
    const double middle = 0.5 * (inside + outside);
    const Trial<Law> trial = runge_kutta(law, from, control, middle, false);
    if (!trial.possible || law.yield_distance(trial.state) > kOutside) {
      outside = middle;
      if (trial.possible) best = trial;
    } else {
      inside = middle;
    }
  }
  fraction = outside;
  return best;
}

}  // namespace

template <class Law>
PointRate point_rate(const Law& law, const typename Law::State& state,
                     const MixedControl& control) {
  const bool yielding = law.on_yield(state);
  return solve(law.tangent(yielding ? law.at_yield(state) : state), control, yielding, false);
}

template <class Law>
PointStep<Law> advance_point(const Law& law, const typename Law::State& state,
                             const MixedControl& control, const PointTolerance& tolerance) {
  PointStep<Law> step;
  step.state = state;
  step.outcome = StepOutcome::accepted;
  if (auto objection = law.objection(state)) {
    step.outcome = StepOutcome::failed;
    step.message = *objection;
    return step;
  }
  Eigen::Vector2d strain = Eigen::Vector2d::Zero();
  double fraction = 1;
  int taken = 0;
  const auto finish = [&](StepOutcome outcome, const std::string& message) {
    step.outcome = outcome;
    step.message = message;
  };
  while (step.done < 1) {
    if (++taken > tolerance.step_limit) {
      finish(StepOutcome::failed, "more integration steps than the limit allows");
      break;
    }
    fraction = std::min(fraction, 1 - step.done);
    const bool yielding = law.on_yield(step.state);
    typename Law::State from = yielding ? law.at_yield(step.state) : step.state;
    const PointRate start = solve(law.tangent(from), control, yielding, false);
    if (!start.controllable) {
      step.culprit = start.culprit;
      if (start.culprit < 0)
        finish(StepOutcome::failed, "the two control conditions do not determine an increment");
      else
        finish(StepOutcome::lost_control, "the control condition cannot be held any longer");
      break;
    }
    if (!start.plastic) from = step.state;
    Trial<Law> trial = runge_kutta(law, from, control, fraction, start.plastic);
    const bool at_limit = fraction <= tolerance.smallest_step;
    if (!trial.possible || trial.error > tolerance.relative) {
      if (!at_limit) {
        const double shrink =
            trial.possible ? 0.9 * std::pow(tolerance.relative / trial.error, 0.2) : 0.25;
        fraction = std::max(fraction * std::clamp(shrink, 0.1, 0.9), 0.5 * tolerance.smallest_step);
        continue;
      }
      if (trial.lost_control) {
        step.culprit = trial.culprit;
        finish(StepOutcome::lost_control, "the control condition cannot be held any longer");
        break;
      }
      if (!trial.possible) {
        // The branch changes within this smallest step: take it elastically.
        trial = runge_kutta(law, step.state, control, fraction, false);
        if (!trial.possible) {
          finish(StepOutcome::failed, "no admissible state within reach of the increment");
          break;
        }
      }
    }
    const bool crossed = !start.plastic && law.yield_distance(trial.state) > kOutside;
    double covered = fraction;
    if (crossed) trial = to_yield(law, from, control, covered);
    step.error = std::max(step.error, trial.error);
    step.state = crossed ? law.at_yield(trial.state) : trial.state;
    strain += trial.strain;
    step.done = covered >= 1 - step.done ? 1 : step.done + covered;
    const double grow = trial.error > 0 ? 0.9 * std::pow(tolerance.relative / trial.error, 0.2) : 5;
    fraction *= std::clamp(grow, 0.2, 5.0);
    fraction = std::max(fraction, tolerance.smallest_step);
  }
  if (step.outcome == StepOutcome::accepted && step.error > tolerance.relative)
    finish(StepOutcome::inaccurate, "the integration error exceeds the tolerance");
  step.stress_increment =
      principal_stress(Eigen::Vector2d(step.state.p - state.p, step.state.q - state.q));
  step.strain_increment = principal_strain(strain);
  return step;
}

template PointRate point_rate(const Sanisand&, const Sanisand::State&, const MixedControl&);
template PointStep<Sanisand> advance_point(const Sanisand&, const Sanisand::State&,
                                           const MixedControl&, const PointTolerance&);

}  // namespace triax::sim

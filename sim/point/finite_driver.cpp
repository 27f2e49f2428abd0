#include "sim/point/finite_driver.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/point/control_solver.hpp"

namespace triax::sim {
namespace {

constexpr double kFinestTolerance = 1e-6;
constexpr int kMostIterations = 30;

template <class Space>
struct Increment {
  bool met = false;
  int culprit = -1;
  PointState<Space> state;
  Vector<Space> strain = Vector<Space>::Zero();
  Matrix<Space> tangent;
  std::string failure;
};

/// Newton's method on S Δσ(Δε) + E Δε = dy.
template <class Space>
Increment<Space> meet(const Law<Space>& law, const PointState<Space>& from,
                      const PreparedControl<Space>& control, double fraction,
                      const Matrix<Space>& tangent) {
  Increment<Space> best;
  best.tangent = tangent;
  const Vector<Space> wanted = fraction * control.increment;
  const double size = std::max(wanted.norm(), 1e-300);
  const auto correction = [&](const Vector<Space>& residual) {
    const Matrix<Space> a = control.stress * best.tangent + control.strain;
    return Vector<Space>(a.fullPivLu().solve(residual));
  };
  best.strain = control.strain_driven ? Vector<Space>(fraction * control.strain_increment)
                                      : correction(wanted);
  for (int i = 0; i < kMostIterations; ++i) {
    if (!best.strain.allFinite()) break;
    FiniteStep<Space> step = law.integrate(from, best.strain);
    best.failure = step.failure;
    if (!step.failure.empty()) return best;
    best.state = step.state;
    best.tangent = step.tangent;
    const Vector<Space> residual =
        wanted - control.stress * (step.state.stress - from.stress) - control.strain * best.strain;
    if (residual.norm() <= 1e-9 * size) {
      best.met = true;
      return best;
    }
    best.strain += correction(residual);
  }
  const Matrix<Space> a = control.stress * best.tangent + control.strain;
  Eigen::Index row = 0;
  a.rowwise().norm().minCoeff(&row);
  best.culprit = static_cast<int>(row);
  return best;
}

}  // namespace

template <class Space>
PointStep<Space> advance_finite(const Law<Space>& law, const PointState<Space>& state,
                                const MixedControl<Space>& wanted,
                                const PointTolerance& tolerance) {
  PointStep<Space> step;
  step.state = state;
  const FiniteStep<Space> probe = law.integrate(state, Vector<Space>::Zero());
  if (!probe.failure.empty()) {
    step.message = probe.failure;
    return step;
  }
  Matrix<Space> tangent = probe.tangent;
  const PreparedControl<Space> control(wanted, std::max(tangent.diagonal().maxCoeff(), 1e-300));
  if (control.strain_driven && !control.determined) {
    step.message = "the control conditions do not determine an increment";
    return step;
  }
  step.outcome = StepOutcome::accepted;
  const double allowed = std::max(tolerance.relative, kFinestTolerance);
  double fraction = 1;
  while (step.done < 1) {
    fraction = std::min(fraction, 1 - step.done);
    const auto whole = meet(law, step.state, control, fraction, tangent);
    auto half = meet(law, step.state, control, fraction / 2, tangent);
    auto second = half.met ? meet(law, half.state, control, fraction / 2, half.tangent) : half;
    const bool met = whole.met && half.met && second.met;
    const double error = met ? (whole.state.stress - second.state.stress).cwiseAbs().maxCoeff() /
                                   std::max(std::abs(second.state.p()), 0.1)
                             : 1;
    if ((!met || error > allowed) && fraction > 1e-6 && ++step.steps < tolerance.step_limit) {
      fraction *= met ? std::clamp(0.9 * std::sqrt(allowed / error), 0.1, 0.9) : 0.25;
      continue;
    }
    if (!met) {
      const auto& bad = !whole.met ? whole : !half.met ? half : second;
      step.culprit = bad.failure.empty() ? bad.culprit : -1;
      step.outcome = bad.failure.empty() ? StepOutcome::lost_control : StepOutcome::failed;
      step.message =
          bad.failure.empty() ? "the control condition cannot be held any longer" : bad.failure;
      break;
    }
    ++step.steps;
    step.state = second.state;
    step.strain_increment += half.strain + second.strain;
    step.error = std::max(step.error, error);
    step.done = fraction >= 1 - step.done ? 1 : step.done + fraction;
    tangent = second.tangent;
    fraction *= error > 0 ? std::clamp(0.9 * std::sqrt(allowed / error), 0.5, 4.0) : 4;
  }
  if (step.outcome == StepOutcome::accepted && step.error > allowed) {
    step.outcome = StepOutcome::inaccurate;
    step.message = "the foreign law's error exceeds the tolerance";
  }
  step.stress_increment = step.state.stress - state.stress;
  return step;
}

template PointStep<Axisymmetric> advance_finite(const Law<Axisymmetric>&,
                                                const PointState<Axisymmetric>&,
                                                const MixedControl<Axisymmetric>&,
                                                const PointTolerance&);
template PointStep<Tensor> advance_finite(const Law<Tensor>&, const PointState<Tensor>&,
                                          const MixedControl<Tensor>&, const PointTolerance&);

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/finite_driver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/control/control_solver.hpp"
#include "sim/mechanics/linear_algebra.hpp"

namespace triax::sim {
namespace {

constexpr double kFinestTolerance = 1e-6;
/// Share of the increment below which it is not cut for the sake of accuracy.
constexpr double kFinestCut = 1e-3;
/// Strain to which an error of strain is related.
constexpr double kStrainScale = 0.01;
constexpr int kMostIterations = 25;
/// Residual at which the control counts as met, of what is asked for and of the stress.
constexpr double kMet = 1e-9, kRoundOff = 1e-13;
/// det(S T + E) over the elastic one from which on a failure to meet the control is its loss.
constexpr double kVanishedTangent = 0.02;
/// Strain of a rate, and strain by which a tangent is found by differences.
constexpr double kRateStrain = 1e-7, kDifference = 1e-8;

/// An attempt at a part of the increment.
template <class Space>
struct Attempt {
  bool met = false;
  bool hopeless = false;  ///< failed in a way that a smaller increment does not mend
  PointState<Space> state;
  Vector<Space> strain = Vector<Space>::Zero();
  Matrix<Space> tangent = Matrix<Space>::Zero();  ///< the last one used
  std::string failure;                            ///< of the law
};

template <class Space>
class FiniteDriver {
 public:
  FiniteDriver(const Law<Space>& law, const PointState<Space>& state,
               const MixedControl<Space>& control, FiniteStep<Space> probe)
      : law_(law),
        elastic_(std::move(probe.tangent)),
        control_(control, std::max(elastic_.diagonal().maxCoeff(), 1e-300)),
        modulus_(std::max(elastic_.diagonal().maxCoeff(), 1e-300)) {
    if (elastic_.isZero(0)) elastic_ = differences(state, Vector<Space>::Zero());
  }

  const PreparedControl<Space>& control() const { return control_; }
  const Matrix<Space>& elastic() const { return elastic_; }
  /// What an elastic law would answer; nothing where the conditions do not determine it.
  std::optional<Vector<Space>> elastic_strain() const {
    return solve_regular<Space>(matrix(elastic_), control_.increment);
  }
  bool determined() const { return !control_.strain_driven || control_.determined; }

  Matrix<Space> matrix(const Matrix<Space>& tangent) const {
    return control_.stress * tangent + control_.strain;
  }
  double determinant(const Matrix<Space>& tangent) const {
    return sim::determinant<Space>(matrix(tangent)) / sim::determinant<Space>(matrix(elastic_));
  }

  /// Newton's method on S Δσ(Δε) + E Δε = fraction dy, begun with `tangent`.
  Attempt<Space> meet(const PointState<Space>& from, double fraction,
                      const Matrix<Space>& tangent) const {
    Attempt<Space> best = newton(from, fraction, tangent, false);
    if (best.met || best.hopeless || !best.failure.empty()) return best;
    Attempt<Space> second = newton(from, fraction, elastic_, true);
    return second.failure.empty() ? second : best;
  }

  /// Largest difference of two results, stress to p′, strain to one per cent.
  double difference(const Attempt<Space>& whole, const PointState<Space>& end,
                    const Vector<Space>& strain) const {
    const double stress = (whole.state.stress - end.stress).cwiseAbs().maxCoeff();
    return std::max(stress / std::max(std::abs(end.p()), 1e-6 * modulus_),
                    (whole.strain - strain).cwiseAbs().maxCoeff() / kStrainScale);
  }

  /// Row that cannot be held, or −1 where the control is not at its limit. The plastic tangent is
  /// looked for beyond the state, where the increment leads.
  int limiting_variable(const PointState<Space>& at, const Attempt<Space>& missed) const {
    if (!elastic_strain()) return row_of(elastic_);
    const Matrix<Space> beyond =
        missed.strain.allFinite() ? differences(at, missed.strain) : missed.tangent;
    for (const Matrix<Space>& tangent : {beyond, missed.tangent})
      if (tangent.allFinite() && determinant(tangent) < kVanishedTangent)
        return critical_row(tangent);
    return -1;
  }

  /// ∂Δσ/∂Δε at this increment by differences; not finite where the law fails.
  Matrix<Space> differences(const PointState<Space>& from, const Vector<Space>& strain) const {
    Matrix<Space> tangent;
    const double h = std::max(kDifference, 1e-4 * strain.norm());
    for (int i = 0; i < Space::kSize; ++i) {
      Vector<Space> more = strain, less = strain;
      more(i) += h;
      less(i) -= h;
      const auto high = law_.integrate(from, more), low = law_.integrate(from, less);
      if (!high.failure.empty() || !low.failure.empty())
        return Matrix<Space>::Constant(std::nan(""));
      tangent.col(i) = (high.state.stress - low.state.stress) / (2 * h);
    }
    return tangent;
  }

 private:
  int row_of(const Matrix<Space>& tangent) const {
    return row_that_limits<Space>(left_null_vector<Space>(matrix(tangent)), control_.increment);
  }

  /// The row that goes first on the way from the elastic tangent to this one, or a little further,
  /// where the determinant passes through zero.
  int critical_row(const Matrix<Space>& tangent) const {
    const auto on_the_way = [&](double part) {
      return Matrix<Space>(elastic_ + part * (tangent - elastic_));
    };
    double low = 0, high = 1;
    while (determinant(on_the_way(high)) > 0) {
      if (high > 4) return -1;
      high *= 1.25;
    }
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (determinant(on_the_way(middle)) > 0 ? low : high) = middle;
    }
    return row_of(on_the_way(high));
  }

  Attempt<Space> newton(const PointState<Space>& from, double fraction,
                        const Matrix<Space>& tangent, bool by_differences) const {
    Attempt<Space> now;
    now.tangent = tangent;
    const Vector<Space> wanted = fraction * control_.increment;
    const double enough = kMet * wanted.norm() + kRoundOff * from.stress.norm();
    now.strain = control_.strain_driven ? Vector<Space>(fraction * control_.strain_increment)
                                        : correction(tangent, wanted);
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostIterations && now.strain.allFinite(); ++i) {
      FiniteStep<Space> step = law_.integrate(from, now.strain);
      now.failure = std::move(step.failure);
      now.hopeless = !now.failure.empty() && !step.smaller;
      if (!now.failure.empty()) return now;
      now.state = std::move(step.state);
      const Vector<Space> residual = wanted - control_.stress * (now.state.stress - from.stress) -
                                     control_.strain * now.strain;
      now.tangent = step.tangent;
      now.met = control_.strain_driven || residual.norm() <= enough;
      if (now.met) return now;
      if (i > 3 && residual.norm() > 0.9 * last) return now;
      last = residual.norm();
      if (by_differences) now.tangent = differences(from, now.strain);
      now.strain += correction(now.tangent, residual);
    }
    return now;
  }

  Vector<Space> correction(const Matrix<Space>& tangent, const Vector<Space>& residual) const {
    return solve<Space>(matrix(tangent), residual);
  }

  const Law<Space>& law_;
  Matrix<Space> elastic_;
  PreparedControl<Space> control_;
  double modulus_;
};

/// The law's answer to no strain, or to next to none where it does not take zero.
template <class Space>
FiniteStep<Space> probe(const Law<Space>& law, const PointState<Space>& state) {
  FiniteStep<Space> step = law.integrate(state, Vector<Space>::Zero());
  if (!step.failure.empty() && step.smaller) step = law.integrate(state, 1e-10 * identity<Space>());
  return step;
}

constexpr const char* kUndetermined = "the control conditions do not determine an increment";

}  // namespace

template <class Space>
PointStep<Space> advance_finite(const Law<Space>& law, const PointState<Space>& state,
                                const MixedControl<Space>& wanted,
                                const PointTolerance& tolerance) {
  PointStep<Space> step;
  step.state = state;
  FiniteStep<Space> first = probe(law, state);
  if (!first.failure.empty()) {
    step.message = first.failure;
    return step;
  }
  const FiniteDriver<Space> driver(law, state, wanted, std::move(first));
  if (!driver.determined()) {
    step.message = kUndetermined;
    return step;
  }
  step.outcome = StepOutcome::accepted;
  const double allowed = std::max(tolerance.relative, kFinestTolerance);
  Matrix<Space> tangent = driver.elastic();
  double fraction = 1;
  while (step.done < 1) {
    if (++step.steps > tolerance.step_limit) {
      step.outcome = StepOutcome::failed;
      step.message = "more integration steps than the limit allows";
      break;
    }
    fraction = std::min(fraction, 1 - step.done);
    const auto whole = driver.meet(step.state, fraction, tangent);
    auto half = whole.met ? driver.meet(step.state, fraction / 2, tangent) : whole;
    auto second = half.met ? driver.meet(half.state, fraction / 2, half.tangent) : half;
    if (!second.met) {
      if (!second.hopeless && fraction > tolerance.smallest_step) {
        fraction = std::max(fraction / 4, 0.5 * tolerance.smallest_step);
        continue;
      }
      step.limiting_variable =
          second.failure.empty() ? driver.limiting_variable(step.state, second) : -1;
      step.outcome = step.limiting_variable >= 0 ? StepOutcome::lost_control : StepOutcome::failed;
      step.message = !second.failure.empty() ? second.failure
                     : step.limiting_variable >= 0
                         ? "the control condition cannot be held any longer"
                         : "the law gives no increment that meets the control conditions";
      break;
    }
    const Vector<Space> strain = half.strain + second.strain;
    const double error = driver.difference(whole, second.state, strain);
    const double change = error > 0 ? 0.9 * std::sqrt(allowed / error) : 4;
    if (error > allowed && fraction > kFinestCut) {
      fraction = std::max(fraction * std::clamp(change, 0.1, 0.9), 0.5 * kFinestCut);
      continue;
    }
    step.state = std::move(second.state);
    step.strain_increment += strain;
    step.error = std::max(step.error, error);
    step.done = fraction >= 1 - step.done ? 1 : step.done + fraction;
    tangent = second.tangent;
    fraction *= std::clamp(change, 0.5, 4.0);
  }
  if (step.outcome == StepOutcome::accepted && step.error > allowed) {
    step.outcome = StepOutcome::inaccurate;
    step.message = "the foreign law's error exceeds the tolerance";
  }
  step.stress_increment = step.state.stress - state.stress;
  return step;
}

template <class Space>
PointRate<Space> finite_rate(const Law<Space>& law, const PointState<Space>& state,
                             const MixedControl<Space>& control) {
  PointRate<Space> rate;
  FiniteStep<Space> first = probe(law, state);
  if (!first.failure.empty()) return rate;
  const FiniteDriver<Space> driver(law, state, control, std::move(first));
  if (!driver.determined()) return rate;
  if (driver.control().increment.isZero(0)) {
    rate.controllable = true;
    return rate;
  }
  const std::optional<Vector<Space>> elastic = driver.elastic_strain();
  if (!elastic || !elastic->allFinite()) {
    rate.determinant = 0;
    rate.limiting_variable = driver.limiting_variable(state, {});
    return rate;
  }
  const double fraction = kRateStrain / elastic->norm();
  const auto small = driver.meet(state, fraction, driver.elastic());
  if (!small.failure.empty()) return rate;
  if (!small.met) {
    rate.limiting_variable = driver.limiting_variable(state, small);
    rate.determinant = 0;
    return rate;
  }
  rate.controllable = true;
  rate.stress = (small.state.stress - state.stress) / fraction;
  rate.strain = small.strain / fraction;
  rate.determinant = driver.determinant(small.tangent);
  return rate;
}

template PointStep<Axisymmetric> advance_finite(const Law<Axisymmetric>&,
                                                const PointState<Axisymmetric>&,
                                                const MixedControl<Axisymmetric>&,
                                                const PointTolerance&);
template PointStep<Tensor> advance_finite(const Law<Tensor>&, const PointState<Tensor>&,
                                          const MixedControl<Tensor>&, const PointTolerance&);
template PointRate<Axisymmetric> finite_rate(const Law<Axisymmetric>&,
                                             const PointState<Axisymmetric>&,
                                             const MixedControl<Axisymmetric>&);
template PointRate<Tensor> finite_rate(const Law<Tensor>&, const PointState<Tensor>&,
                                       const MixedControl<Tensor>&);

}  // namespace triax::sim

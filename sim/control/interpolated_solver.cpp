// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control/interpolated_solver.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "sim/law/interpolated_compliance.hpp"
#include "sim/mechanics/linear_algebra.hpp"

namespace triax::sim {
namespace {

/// The principal components of a tensor whose shear components are zero and stay so.
struct Principal {
  static constexpr int kSize = 3;
};

/// Two or three equations in closed form.
template <class Space>
Vector<Space> solution(const Matrix<Space>& a, const Vector<Space>& b) {
  if constexpr (Space::kSize <= 3)
    return a.inverse() * b;
  else
    return sim::solve<Space>(a, b);
}
template <class Space>
double determinant_of(const Matrix<Space>& a) {
  if constexpr (Space::kSize <= 3)
    return a.determinant();
  else
    return determinant<Space>(a);
}

/// Newton's method on the interpolated form, for the first components of the control. Where all
/// strains are given the conditions are dε = what they give.
template <class Space, class Whole, bool kStrainDriven>
class InterpolatedSolver {
  static constexpr int kSize = Space::kSize;

 public:
  InterpolatedSolver(const InterpolatedForm<Whole>& form, const PreparedControl<Whole>& control,
                     PointRate<Space>& rate)
      : law_(form.plus.template topLeftCorner<kSize, kSize>(),
             form.minus.template topLeftCorner<kSize, kSize>(), form.quadratic),
        control_(control),
        wanted_(
            (kStrainDriven ? control.strain_increment : control.increment).template head<kSize>()),
        rate_(rate) {
    if (kStrainDriven) return;
    s_ = control.stress.template topLeftCorner<kSize, kSize>();
    e_ = control.strain.template topLeftCorner<kSize, kSize>();
  }

  void solve(const Vector<Space>& guess) {
    if (!std::isfinite(law_.mean().sum())) return;  // the base has no answer here
    square_ = wanted_.squaredNorm();
    if (square_ == 0) {
      rate_.controllable = true;
      return;
    }
    bool found = guess.squaredNorm() > 0 && newton(guess);
    if (!found) {
      const Vector<Space> linear = start();
      found = newton(linear) || picard(linear);
    }
    // Sign and size relative to the diagonal part, which is positive definite.
    const Vector<Space> diagonal = law_.mean().diagonal();
    const double reference =
        kStrainDriven ? diagonal.prod()
                      : determinant_of<Space>(s_ + e_ * Matrix<Space>(diagonal.asDiagonal()));
    const Matrix<Space> tangent = law_.tangent(at_);
    rate_.determinant = determinant_of<Space>(conditions_on(tangent)) / reference;
    if (!found || !(rate_.determinant > 1e-9)) return lost(tangent);
    rate_.stress = at_.stress;
    rate_.strain = at_.strain;
    rate_.controllable = std::isfinite(rate_.stress.sum() + rate_.strain.sum());
  }

 private:
  using Instant = typename InterpolatedCompliance<Space>::Instant;

  /// ∂(S dσ + E dε)/∂dσ
  Matrix<Space> conditions_on(const Matrix<Space>& compliance) const {
    if (kStrainDriven) return compliance;
    return s_ + e_ * compliance;
  }
  Vector<Space> residual(const Instant& at) const {
    if (kStrainDriven) return at.strain - wanted_;
    return s_ * at.stress + e_ * at.strain - wanted_;
  }
  void lost(const Matrix<Space>& tangent) {
    if constexpr (std::is_same_v<Space, Whole>)  // else the whole control is asked again
      rate_.limiting_variable = row_that_limits<Space>(
          left_null_vector<Space>(control_.stress + control_.strain * tangent), control_.increment);
    rate_.determinant = std::min(rate_.determinant, 0.0);
  }

  Vector<Space> start() const {
    Vector<Space> v = solution<Space>(conditions_on(law_.mean()), wanted_);
    if (!v.allFinite() || v.squaredNorm() == 0) v = isotropic_direction();
    return v;
  }
  static Vector<Space> isotropic_direction() {
    if constexpr (kSize == 3)
      return Vector<Space>::Ones();
    else
      return identity<Space>();
  }

  bool newton(const Vector<Space>& first) {
    at_ = law_.at(first);
    Vector<Space> rest = residual(at_);
    double left = rest.squaredNorm();
    for (int i = 0; i < 40; ++i) {
      if (left <= 1e-26 * square_) return true;
      const Vector<Space> step = solution<Space>(conditions_on(law_.tangent(at_)), rest);
      if (!step.allFinite()) return false;
      for (double part = 1;; part /= 2) {
        if (part < 1e-3) return left <= 1e-20 * square_;
        const Vector<Space> next = at_.stress - part * step;
        if (next.squaredNorm() == 0) continue;
        const Instant tried = law_.at(next);
        rest = residual(tried);
        const double now = rest.squaredNorm(), enough = 1 - 1e-4 * part;
        if (!(now < enough * enough * left)) continue;
        at_ = tried;
        left = now;
        break;
      }
    }
    return false;
  }

  bool picard(Vector<Space> v) {
    for (int i = 0; i < 100; ++i) {
      const Vector<Space> next = solution<Space>(conditions_on(law_.secant(v)), wanted_);
      if (!next.allFinite() || next.squaredNorm() == 0) return false;
      v = i < 30 ? next : Vector<Space>(0.5 * (v + next));
      if (residual(law_.at(v)).squaredNorm() <= 1e-12 * square_) return newton(v);
    }
    return false;
  }

  const InterpolatedCompliance<Space> law_;
  const PreparedControl<Whole>& control_;
  const Vector<Space> wanted_;
  Matrix<Space> s_, e_;
  double square_ = 0;  // |wanted|²
  Instant at_;
  PointRate<Space>& rate_;  // of no control at first
};

/// Whether no shear component is coupled with another component.
bool shear_is_apart(const Matrix<Tensor>& m) {
  return m.topRightCorner<3, 3>().isZero(0) && m.bottomLeftCorner<3, 3>().isZero(0) &&
         m(3, 4) == 0 && m(3, 5) == 0 && m(4, 3) == 0 && m(4, 5) == 0 && m(5, 3) == 0 &&
         m(5, 4) == 0;
}

template <class Space, class Whole>
void solve_components(const InterpolatedForm<Whole>& form, const PreparedControl<Whole>& control,
                      const Vector<Space>& guess, PointRate<Space>& rate) {
  if (control.strain_driven && control.determined)
    InterpolatedSolver<Space, Whole, true>(form, control, rate).solve(guess);
  else
    InterpolatedSolver<Space, Whole, false>(form, control, rate).solve(guess);
}

}  // namespace

template <class Space>
PointRate<Space> solve_interpolated(const InterpolatedForm<Space>& form,
                                    const PreparedControl<Space>& control,
                                    const Vector<Space>& guess) {
  PointRate<Space> rate;
  if constexpr (Space::kSize == 6)
    if (control.principal && shear_is_apart(form.plus) && shear_is_apart(form.minus)) {
      PointRate<Principal> found;
      solve_components<Principal, Tensor>(form, control, guess.template head<3>(), found);
      if (found.controllable) {
        rate.controllable = true;
        rate.stress.template head<3>() = found.stress;
        rate.strain.template head<3>() = found.strain;
        rate.determinant = found.determinant;
        return rate;
      }
    }
  solve_components<Space, Space>(form, control, guess, rate);
  return rate;
}

template PointRate<Axisymmetric> solve_interpolated(const InterpolatedForm<Axisymmetric>&,
                                                    const PreparedControl<Axisymmetric>&,
                                                    const Vector<Axisymmetric>&);
template PointRate<Tensor> solve_interpolated(const InterpolatedForm<Tensor>&,
                                              const PreparedControl<Tensor>&,
                                              const Vector<Tensor>&);

}  // namespace triax::sim

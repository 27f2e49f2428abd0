// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control/interpolated_solver.hpp"

#include <algorithm>
#include <cmath>

#include "sim/law/interpolated_compliance.hpp"
#include "sim/mechanics/linear_algebra.hpp"

namespace triax::sim {
namespace {

/// Newton's method on the interpolated form.
template <class Space>
class InterpolatedSolver {
 public:
  InterpolatedSolver(const InterpolatedForm<Space>& form, const PreparedControl<Space>& control)
      : law_(form), control_(control) {}

  PointRate<Space> solve(const Vector<Space>& guess) {
    if (!std::isfinite(law_.mean().sum())) return rate_;  // the base has no answer here
    const double size = control_.increment.norm();
    if (size == 0) {
      rate_.controllable = true;
      return rate_;
    }
    bool found = guess.squaredNorm() > 0 && newton(guess, size);
    if (!found) {
      const Vector<Space> linear = start();
      found = newton(linear, size) || picard(linear, size);
    }
    const Matrix<Space> jacobian = control_.stress + control_.strain * law_.tangent(stress_);
    // Sign and size relative to the diagonal part, which is positive definite.
    const Matrix<Space> reference =
        control_.stress + control_.strain * Matrix<Space>(law_.mean().diagonal().asDiagonal());
    rate_.determinant = determinant<Space>(jacobian) / determinant<Space>(reference);
    if (!found || !(rate_.determinant > 1e-9)) {
      rate_.limiting_variable =
          row_that_limits<Space>(left_null_vector<Space>(jacobian), control_.increment);
      rate_.determinant = std::min(rate_.determinant, 0.0);
      return rate_;
    }
    rate_.stress = stress_;
    rate_.strain = law_.strain(stress_);
    rate_.controllable = std::isfinite(rate_.stress.sum() + rate_.strain.sum());
    return rate_;
  }

 private:
  Vector<Space> residual(const Vector<Space>& v) const {
    return control_.stress * v + control_.strain * law_.strain(v) - control_.increment;
  }
  Vector<Space> start() const {
    const Matrix<Space> a = control_.stress + control_.strain * law_.mean();
    Vector<Space> v = sim::solve<Space>(a, control_.increment);
    if (!v.allFinite() || v.squaredNorm() == 0) v = identity<Space>();
    return v;
  }

  bool newton(Vector<Space> v, double size) {
    Vector<Space> r = residual(v);
    for (int i = 0; i < 40; ++i) {
      stress_ = v;
      if (r.norm() <= 1e-13 * size) return true;
      const Matrix<Space> jacobian = control_.stress + control_.strain * law_.tangent(v);
      const Vector<Space> step = sim::solve<Space>(jacobian, r);
      if (!step.allFinite()) return false;
      double part = 1;
      for (;; part /= 2) {
        if (part < 1e-3) return r.norm() <= 1e-10 * size;
        const Vector<Space> next = v - part * step;
        if (next.squaredNorm() == 0) continue;
        const Vector<Space> rest = residual(next);
        if (!(rest.norm() < (1 - 1e-4 * part) * r.norm())) continue;
        v = next;
        r = rest;
        break;
      }
    }
    return false;
  }

  bool picard(Vector<Space> v, double size) {
    for (int i = 0; i < 100; ++i) {
      const Matrix<Space> a = control_.stress + control_.strain * law_.secant(v);
      const Vector<Space> next = sim::solve<Space>(a, control_.increment);
      if (!next.allFinite() || next.squaredNorm() == 0) return false;
      v = i < 30 ? next : Vector<Space>(0.5 * (v + next));
      if (residual(v).norm() <= 1e-6 * size) return newton(v, size);
    }
    return false;
  }

  InterpolatedCompliance<Space> law_;
  const PreparedControl<Space>& control_;
  Vector<Space> stress_;
  PointRate<Space> rate_;
};

}  // namespace

template <class Space>
PointRate<Space> solve_interpolated(const InterpolatedForm<Space>& form,
                                    const PreparedControl<Space>& control,
                                    const Vector<Space>& guess) {
  return InterpolatedSolver<Space>(form, control).solve(guess);
}

template PointRate<Axisymmetric> solve_interpolated(const InterpolatedForm<Axisymmetric>&,
                                                    const PreparedControl<Axisymmetric>&,
                                                    const Vector<Axisymmetric>&);
template PointRate<Tensor> solve_interpolated(const InterpolatedForm<Tensor>&,
                                              const PreparedControl<Tensor>&,
                                              const Vector<Tensor>&);

}  // namespace triax::sim

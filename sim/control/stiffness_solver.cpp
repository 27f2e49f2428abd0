// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control/stiffness_solver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/mechanics/linear_algebra.hpp"

namespace triax::sim {
namespace {

/// Below this share of its natural size a determinant counts as zero.
constexpr double kSingular = 1e-12;

template <class Space>
double determinant_scale(const Matrix<Space>& a) {
  double size = 1;
  for (int row = 0; row < Space::kSize; ++row) size *= a.row(row).norm();
  return size;
}

/// LU of the control matrix; by hand in two dimensions, where it is a few operations.
template <class Space>
class ControlMatrix {
 public:
  explicit ControlMatrix(const Matrix<Space>& a) {
    double determinant = 0;
    if constexpr (Space::kSize == 2) {
      determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
      inverse_ << a(1, 1), -a(0, 1), -a(1, 0), a(0, 0);
      inverse_ /= determinant;
    } else {
      lu_ = Factors<Space>(a);
      determinant = lu_.determinant();
    }
    regular_ = std::abs(determinant) > kSingular * determinant_scale<Space>(a);
  }
  bool regular() const { return regular_; }
  Vector<Space> solve(const Vector<Space>& b) const {
    if constexpr (Space::kSize == 2)
      return inverse_ * b;
    else
      return lu_.solve(b);
  }

 private:
  struct Nothing {};
  std::conditional_t<Space::kSize == 2, Matrix<Space>, Nothing> inverse_;
  std::conditional_t<Space::kSize == 2, Nothing, Factors<Space>> lu_;
  bool regular_ = false;
};

template <class Space>
class StiffnessSolver {
 public:
  StiffnessSolver(const StiffnessForm<Space>& form, const PreparedControl<Space>& control,
                  PointRate<Space>& rate)
      : form_(form), control_(control), rate_(rate) {}

  void solve(const Branch& branch) {
    if (control_.strain_driven) {
      if (!control_.determined) return;
      x_ = control_.strain_increment;
    } else {
      a_.noalias() = control_.stress * form_.stiffness;
      a_ += control_.strain;
      matrix_.emplace(a_);
      if (!matrix_->regular()) return;
      x_ = matrix_->solve(control_.increment);
    }
    if (form_.nonlinear)
      solve_norm();
    else if (form_.mechanisms > 0)
      solve_mechanisms(branch);
    else
      finish(x_);
  }

 private:
  void finish(const Vector<Space>& strain) {
    rate_.strain = strain;
    rate_.stress.noalias() = form_.stiffness * strain;
    for (unsigned k = 0; k < static_cast<unsigned>(form_.mechanisms); ++k)
      if (rate_.multiplier[k] != 0) rate_.stress -= rate_.multiplier[k] * form_.relaxation[k];
    if (form_.nonlinear) rate_.stress -= strain.norm() * form_.norm_term;
    rate_.controllable = std::isfinite(rate_.stress.sum() + rate_.strain.sum());
  }

  /// `direction`: m of the mechanisms that load, or dε/|dε|.
  void lose(const Vector<Space>& direction) {
    const Matrix<Space> a = control_.strain_driven ? control_.strain : a_;
    const Matrix<Space> transposed = a.transpose();
    rate_.multiplier.fill(0);
    rate_.determinant = 0;
    rate_.limiting_variable =
        row_that_limits<Space>(sim::solve<Space>(transposed, direction), control_.increment);
  }

  void solve_norm() {
    if (control_.strain_driven) return finish(x_);
    const Vector<Space> b = matrix_->solve(control_.stress * form_.norm_term);
    const double bb = b.squaredNorm(), xb = x_.dot(b), xx = x_.squaredNorm();
    double length = -1;
    if (xx == 0) {
      length = 0;
    } else if (const double root = xb * xb + (1 - bb) * xx; root >= 0) {
      // The smaller root ≥ 0 of (1 − bb) X² − 2 xb X − xx, in the form without cancellation.
      const double s = std::sqrt(root);
      length = s - xb > 0 ? xx / (s - xb) : -1;
    }
    const Vector<Space> strain = x_ + b * length;
    rate_.determinant = length > 0 ? 1 - b.dot(strain) / length : 1;
    if (length < 0 || !(rate_.determinant > kSingular)) {
      return lose(length > 0 ? Vector<Space>(strain / length) : last_direction(b));
    }
    finish(strain);
  }

  /// Where |b| > 1 the x that can be reached fill a cone around −b, whose boundary has the normals
  /// d with b·d = 1. Of these the one that parts this x from the cone: the direction in which the
  /// conditions were last met before they went out of reach.
  Vector<Space> last_direction(const Vector<Space>& b) const {
    const double bb = b.squaredNorm();
    const Vector<Space> across = x_ - (x_.dot(b) / bb) * b;
    const double size = across.norm();
    Vector<Space> direction = b / bb;
    if (bb > 1 && size > 0) direction += (std::sqrt(1 - 1 / bb) / size) * across;
    return direction;
  }

  /// Multipliers of the set; false where its determinant is not positive.
  bool try_set(unsigned set) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Identity(), h = m;  // mechanisms not in the set: λ = 0
    Eigen::Vector3d t = Eigen::Vector3d::Zero();
    for (int i = 0; i < form_.mechanisms; ++i) {
      if (!(set >> i & 1U)) continue;
      t(i) = trial_(i);
      for (int j = 0; j < form_.mechanisms; ++j) {
        if (!(set >> j & 1U)) continue;
        m(i, j) = coupling_(i, j);
        h(i, j) = form_.hardening(i, j);
      }
    }
    rate_.determinant = m.determinant() / h.determinant();
    if (!(rate_.determinant > kSingular)) return false;
    const Eigen::Vector3d lambda = m.inverse() * t;
    for (int i = 0; i < form_.mechanisms; ++i)
      rate_.multiplier[static_cast<std::size_t>(i)] = lambda(i);
    return true;
  }

  bool is_consistent(unsigned set, unsigned on_yield) const {
    for (int k = 0; k < form_.mechanisms; ++k) {
      const auto u = static_cast<std::size_t>(k);
      if (set >> k & 1U) {
        if (!(rate_.multiplier[u] >= 0)) return false;
      } else if (on_yield >> k & 1U) {
        double excess = trial_(k), size = std::abs(trial_(k));
        for (int j = 0; j < form_.mechanisms; ++j) {
          const double part = coupling_(k, j) * rate_.multiplier[static_cast<std::size_t>(j)];
          excess -= part;
          size += std::abs(part);
        }
        if (excess > 1e-9 * size) return false;
      }
    }
    return true;
  }

  void take(unsigned set) {
    Vector<Space> strain = x_;
    if (!control_.strain_driven)
      for (unsigned k = 0; k < static_cast<unsigned>(form_.mechanisms); ++k)
        if (set >> k & 1U) strain += relief_[k] * rate_.multiplier[k];
    rate_.active = set;
    finish(strain);
  }

  void lose_set(unsigned set) {
    Vector<Space> direction = Vector<Space>::Zero();
    for (unsigned k = 0; k < static_cast<unsigned>(form_.mechanisms); ++k)
      if (set >> k & 1U) direction += form_.trigger[k].normalized();
    lose(direction);
  }

  /// The usual case without the search among sets.
  void solve_single(const Branch& branch) {
    const bool may = branch.forced.value_or(branch.on_yield) & 1U;
    const double trial = form_.trigger[0].dot(x_);
    if (!may || (!branch.forced && !(trial > 0))) return take(0);
    double m = form_.hardening(0, 0);
    const double h = m;
    if (!control_.strain_driven) {
      relief_[0] = matrix_->solve(control_.stress * form_.relaxation[0]);
      m -= form_.trigger[0].dot(relief_[0]);
    }
    if (!(m > kSingular * (std::abs(h) + std::abs(m - h)))) return lose_set(1);
    if (!control_.strain_driven) rate_.determinant = m / h;
    rate_.multiplier[0] = trial / m;
    take(1);
  }

  void solve_mechanisms(const Branch& branch) {
    if (form_.mechanisms == 1) return solve_single(branch);
    const unsigned candidates = branch.forced.value_or(branch.on_yield);
    for (int k = 0; k < form_.mechanisms; ++k) {
      const auto u = static_cast<std::size_t>(k);
      trial_(k) = form_.trigger[u].dot(x_);
      if (!control_.strain_driven && (candidates >> k & 1U))
        relief_[u] = matrix_->solve(control_.stress * form_.relaxation[u]);
    }
    for (int k = 0; k < form_.mechanisms; ++k)
      for (int j = 0; j < form_.mechanisms; ++j) {
        coupling_(k, j) = form_.hardening(k, j);
        if (!control_.strain_driven && (candidates >> j & 1U))
          coupling_(k, j) -=
              form_.trigger[static_cast<std::size_t>(k)].dot(relief_[static_cast<std::size_t>(j)]);
      }
    if (branch.forced) {
      if (*branch.forced == 0 || try_set(*branch.forced)) return take(*branch.forced);
      return lose_set(*branch.forced);
    }
    // Few mechanisms: try every set, the smallest first; the first consistent one is it.
    unsigned loading = 0;
    for (const unsigned set : {0U, 1U, 2U, 4U, 3U, 5U, 6U, 7U}) {
      if ((set & ~candidates) != 0) continue;
      rate_.multiplier.fill(0);
      rate_.determinant = 1;
      if (set != 0 && !try_set(set)) {
        loading |= set;
        continue;
      }
      if (is_consistent(set, candidates)) return take(set);
    }
    lose_set(loading != 0 ? largest_trial(loading) : candidates);
  }

  /// Of the sets without a solution, the mechanisms that the increment pushes.
  unsigned largest_trial(unsigned loading) const {
    unsigned pushed = 0;
    for (int k = 0; k < form_.mechanisms; ++k)
      if ((loading >> k & 1U) && trial_(k) > 0) pushed |= 1U << k;
    return pushed != 0 ? pushed : loading;
  }

  const StiffnessForm<Space>& form_;
  const PreparedControl<Space>& control_;
  Matrix<Space> a_;
  std::optional<ControlMatrix<Space>> matrix_;
  Vector<Space> x_;
  std::array<Vector<Space>, kMostMechanisms> relief_;
  Eigen::Vector3d trial_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d coupling_;
  PointRate<Space>& rate_;  // of no control at first
};

}  // namespace

template <class Space>
PointRate<Space> solve_stiffness(const StiffnessForm<Space>& form,
                                 const PreparedControl<Space>& control, const Branch& branch) {
  PointRate<Space> rate;
  StiffnessSolver<Space>(form, control, rate).solve(branch);
  return rate;
}

template PointRate<Axisymmetric> solve_stiffness(const StiffnessForm<Axisymmetric>&,
                                                 const PreparedControl<Axisymmetric>&,
                                                 const Branch&);
template PointRate<Tensor> solve_stiffness(const StiffnessForm<Tensor>&,
                                           const PreparedControl<Tensor>&, const Branch&);

}  // namespace triax::sim

#include "sim/point/control_solver.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace triax::sim {

template <class Space>
PreparedControl<Space>::PreparedControl(const MixedControl<Space>& c, double modulus_pa)
    : stress(c.stress), strain(c.strain), increment(c.increment) {
  for (int row = 0; row < Space::kSize; ++row) {
    const double size =
        stress.row(row).cwiseAbs().maxCoeff() + strain.row(row).cwiseAbs().maxCoeff() / modulus_pa;
    if (size <= 0) continue;
    stress.row(row) /= size;
    strain.row(row) /= size;
    increment(row) /= size;
  }
  strain_driven = stress.isZero(0);
  if (!strain_driven) return;
  const Eigen::FullPivLU<Matrix<Space>> lu(strain);
  determined = lu.isInvertible();
  if (determined) strain_increment = lu.solve(increment);
}

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
    if constexpr (Space::kSize == 2) {
      determinant_ = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
      inverse_ << a(1, 1), -a(0, 1), -a(1, 0), a(0, 0);
      inverse_ /= determinant_;
    } else {
      lu_.compute(a);
      determinant_ = lu_.determinant();
    }
    regular_ = std::abs(determinant_) > kSingular * determinant_scale<Space>(a);
  }
  bool regular() const { return regular_; }
  double determinant() const { return determinant_; }
  Vector<Space> solve(const Vector<Space>& b) const {
    if constexpr (Space::kSize == 2)
      return inverse_ * b;
    else
      return lu_.solve(b);
  }

 private:
  struct Nothing {};
  std::conditional_t<Space::kSize == 2, Matrix<Space>, Nothing> inverse_;
  std::conditional_t<Space::kSize == 2, Nothing, Eigen::PartialPivLU<Matrix<Space>>> lu_;
  double determinant_ = 0;
  bool regular_ = false;
};

}  // namespace

template <class Space>
int culprit_row(const Matrix<Space>& singular, const Vector<Space>& increment) {
  Vector<Space> scale;
  for (int row = 0; row < Space::kSize; ++row)
    scale(row) = 1 / std::max(singular.row(row).norm(), 1e-300);
  const Matrix<Space> scaled = scale.asDiagonal() * singular;
  const Eigen::SelfAdjointEigenSolver<Matrix<Space>> eigen(scaled * scaled.transpose());
  const Vector<Space> weight = scale.cwiseProduct(eigen.eigenvectors().col(0));
  Vector<Space> share = weight.cwiseProduct(increment).cwiseAbs();
  if (share.maxCoeff() < 1e-9 * weight.cwiseAbs().maxCoeff() * increment.cwiseAbs().maxCoeff())
    share = weight.cwiseAbs();
  Eigen::Index row = 0;
  share.maxCoeff(&row);
  return static_cast<int>(row);
}

namespace {

using Multipliers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostMechanisms, 1>;
using Couplings =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostMechanisms, kMostMechanisms>;

/// Smallest share of det H that det M may have.
bool solvable(double determinant) { return determinant > kSingular; }

template <class Space>
class StiffnessSolver {
 public:
  StiffnessSolver(const StiffnessForm<Space>& form, const PreparedControl<Space>& control)
      : form_(form), control_(control) {}

  PointRate<Space> solve(const Branch& branch) {
    if (control_.strain_driven) {
      if (!control_.determined) return rate_;
      x_ = control_.strain_increment;
    } else {
      a_.noalias() = control_.stress * form_.stiffness;
      a_ += control_.strain;
      matrix_.emplace(a_);
      if (!matrix_->regular()) return rate_;
      x_ = matrix_->solve(control_.increment);
    }
    if (form_.nonlinear)
      solve_norm();
    else if (form_.mechanisms > 0)
      solve_mechanisms(branch);
    else
      finish(x_);
    return rate_;
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

  void lose(const Matrix<Space>& tangent) {
    const Matrix<Space> singular = control_.stress * tangent + control_.strain;
    rate_.culprit = culprit_row<Space>(singular, control_.increment);
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
      const Vector<Space> direction =
          length > 0 ? Vector<Space>(strain / length) : Vector<Space>(b.normalized());
      rate_.determinant = 0;
      return lose(form_.stiffness - form_.norm_term * direction.transpose());
    }
    finish(strain);
  }

  /// Multipliers of the set; false where its determinant is not positive.
  bool try_set(unsigned set) {
    std::array<int, kMostMechanisms> index{};
    int n = 0;
    for (int k = 0; k < form_.mechanisms; ++k)
      if (set >> k & 1U) index[static_cast<std::size_t>(n++)] = k;
    if (n == 1) {
      const int k = index[0];
      const auto u = static_cast<std::size_t>(k);
      const double m = coupling_(k, k), h = form_.hardening(k, k);
      rate_.determinant = h != 0 ? m / h : 0;
      rate_.multiplier[u] = trial_(k) / m;
      return solvable(m / (std::abs(h) + std::abs(m - h)));
    }
    Couplings m(n, n), h(n, n);
    Multipliers t(n);
    for (int i = 0; i < n; ++i) {
      const int k = index[static_cast<std::size_t>(i)];
      t(i) = trial_(k);
      for (int j = 0; j < n; ++j) {
        m(i, j) = coupling_(k, index[static_cast<std::size_t>(j)]);
        h(i, j) = form_.hardening(k, index[static_cast<std::size_t>(j)]);
      }
    }
    rate_.determinant = m.determinant() / h.determinant();
    if (!solvable(rate_.determinant)) return false;
    const Multipliers lambda = m.fullPivLu().solve(t);
    for (int i = 0; i < n; ++i)
      rate_.multiplier[static_cast<std::size_t>(index[static_cast<std::size_t>(i)])] = lambda(i);
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
    Matrix<Space> tangent = form_.stiffness;
    std::array<unsigned, kMostMechanisms> index{};
    int n = 0;
    for (unsigned k = 0; k < static_cast<unsigned>(form_.mechanisms); ++k)
      if (set >> k & 1U) index[static_cast<std::size_t>(n++)] = k;
    Couplings h(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        h(i, j) = form_.hardening(static_cast<int>(index[static_cast<std::size_t>(i)]),
                                  static_cast<int>(index[static_cast<std::size_t>(j)]));
    const Couplings inverse = h.fullPivLu().solve(Couplings::Identity(n, n));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        tangent -= inverse(i, j) * form_.relaxation[index[static_cast<std::size_t>(i)]] *
                   form_.trigger[index[static_cast<std::size_t>(j)]].transpose();
    rate_.multiplier.fill(0);
    rate_.determinant = 0;
    lose(tangent);
  }

  void solve_mechanisms(const Branch& branch) {
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
  PointRate<Space> rate_;
};

/// Newton's method on the interpolated form.
template <class Space>
class InterpolatedSolver {
 public:
  InterpolatedSolver(const InterpolatedForm<Space>& form, const PreparedControl<Space>& control)
      : mean_(0.5 * (form.plus + form.minus)),
        half_(0.5 * (form.plus - form.minus)),
        quadratic_(form.quadratic),
        control_(control) {}

  PointRate<Space> solve(const Vector<Space>& guess) {
    const double size = control_.increment.norm();
    if (size == 0) {
      rate_.controllable = true;
      return rate_;
    }
    const Vector<Space> linear = start();
    bool found = guess.squaredNorm() > 0 && newton(guess, size);
    if (!found) found = newton(linear, size) || picard(linear, size);
    const Matrix<Space> jacobian = control_.stress + control_.strain * tangent(stress_);
    // Sign and size relative to the diagonal part, which is positive definite.
    const Matrix<Space> reference =
        control_.stress + control_.strain * Matrix<Space>(mean_.diagonal().asDiagonal());
    rate_.determinant = jacobian.determinant() / reference.determinant();
    if (!found || !(rate_.determinant > 1e-9)) {
      rate_.culprit = culprit_row<Space>(jacobian, control_.increment);
      rate_.determinant = std::min(rate_.determinant, 0.0);
      return rate_;
    }
    rate_.stress = stress_;
    rate_.strain = response(stress_);
    rate_.controllable = std::isfinite(rate_.stress.sum() + rate_.strain.sum());
    return rate_;
  }

 private:
  static double single(const Vector<Space>& v, int j) {  // dσ_j from its orthonormal component
    return Space::kSize == 2 && j == 1 ? v(j) / std::numbers::sqrt2 : v(j);
  }
  /// The vector that half_ multiplies.
  Vector<Space> weighted(const Vector<Space>& v) const {
    const double norm = v.norm();
    Vector<Space> w = Vector<Space>::Zero();
    for (int j = 0; j < axes(); ++j)
      w(j) = quadratic_ ? v(j) * single(v, j) / norm : std::abs(v(j));
    return w;
  }
  static int axes() { return Space::kSize == 2 ? 2 : 3; }
  Vector<Space> response(const Vector<Space>& v) const { return mean_ * v + half_ * weighted(v); }
  Matrix<Space> tangent(const Vector<Space>& v) const {
    const double norm = v.norm();
    Matrix<Space> inner = Matrix<Space>::Zero();
    for (int j = 0; j < axes(); ++j)
      inner(j, j) = quadratic_ ? 2 * single(v, j) / norm : (v(j) >= 0 ? 1 : -1);
    if (quadratic_) inner -= weighted(v) * v.transpose() / (norm * norm);
    return mean_ + half_ * inner;
  }
  Matrix<Space> secant(const Vector<Space>& v) const {
    const double norm = v.norm();
    Vector<Space> w = Vector<Space>::Zero();
    for (int j = 0; j < axes(); ++j) w(j) = quadratic_ ? single(v, j) / norm : (v(j) >= 0 ? 1 : -1);
    return mean_ + half_ * w.asDiagonal();
  }
  Vector<Space> residual(const Vector<Space>& v) const {
    return control_.stress * v + control_.strain * response(v) - control_.increment;
  }
  Vector<Space> start() const {
    const Matrix<Space> a = control_.stress + control_.strain * mean_;
    Vector<Space> v = a.partialPivLu().solve(control_.increment);
    if (!v.allFinite() || v.squaredNorm() == 0) v = identity<Space>();
    return v;
  }

  bool newton(Vector<Space> v, double size) {
    Vector<Space> r = residual(v);
    for (int i = 0; i < 40; ++i) {
      stress_ = v;
      if (r.norm() <= 1e-13 * size) return true;
      const Matrix<Space> jacobian = control_.stress + control_.strain * tangent(v);
      const Vector<Space> step = jacobian.partialPivLu().solve(r);
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
      const Matrix<Space> a = control_.stress + control_.strain * secant(v);
      const Vector<Space> next = a.partialPivLu().solve(control_.increment);
      if (!next.allFinite() || next.squaredNorm() == 0) return false;
      v = i < 30 ? next : Vector<Space>(0.5 * (v + next));
      if (residual(v).norm() <= 1e-6 * size) return newton(v, size);
    }
    return false;
  }

  Matrix<Space> mean_, half_;
  bool quadratic_;
  const PreparedControl<Space>& control_;
  Vector<Space> stress_;
  PointRate<Space> rate_;
};

}  // namespace

template <class Space>
PointRate<Space> solve_control(const Response<Space>& response,
                               const PreparedControl<Space>& control, const Branch& branch,
                               const Vector<Space>& guess) {
  if (const auto* form = std::get_if<StiffnessForm<Space>>(&response))
    return StiffnessSolver<Space>(*form, control).solve(branch);
  return InterpolatedSolver<Space>(std::get<InterpolatedForm<Space>>(response), control)
      .solve(guess);
}

template struct PreparedControl<Axisymmetric>;
template struct PreparedControl<Tensor>;
template PointRate<Axisymmetric> solve_control(const Response<Axisymmetric>&,
                                               const PreparedControl<Axisymmetric>&, const Branch&,
                                               const Vector<Axisymmetric>&);
template PointRate<Tensor> solve_control(const Response<Tensor>&, const PreparedControl<Tensor>&,
                                         const Branch&, const Vector<Tensor>&);

template int culprit_row<Axisymmetric>(const Matrix<Axisymmetric>&, const Vector<Axisymmetric>&);
template int culprit_row<Tensor>(const Matrix<Tensor>&, const Vector<Tensor>&);

}  // namespace triax::sim

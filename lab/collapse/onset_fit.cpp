// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/onset_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace triax::lab {
namespace {

using Signal = PathSample::Signal;
constexpr int kTerms = 4;
constexpr double kEdge = 0.9;  ///< a root farther out is an extrapolation
using Vector = Eigen::Matrix<double, kTerms, 1>;
using Matrix = Eigen::Matrix<double, kTerms, kTerms>;

/// Legendre polynomials over [−1, 1], their first and second derivatives.
Vector terms(double x) { return {1, x, (3 * x * x - 1) / 2, (5 * x * x - 3) * x / 2}; }
Vector slopes(double x) { return {0, 1, 3 * x, (15 * x * x - 3) / 2}; }
Vector curvatures(double x) { return {0, 0, 3, 15 * x}; }

/// One signal: coefficients, and the variance of a block about them as far as it matters for a fit
/// over many blocks.
struct Cubic {
  Vector c = Vector::Zero();
  double variance = 0;
  double value(double x) const { return c.dot(terms(x)); }
  double slope(double x) const { return c.dot(slopes(x)); }
  double curvature(double x) const { return c.dot(curvatures(x)); }
};

/// All signals of a window over x in [−1, 1].
class Fit {
 public:
  explicit Fit(std::span<const PathSample> blocks);
  const Cubic& operator[](Signal k) const { return cubics_[k]; }
  double reading(double x) const { return middle_ + half_ * x; }
  double x_of(double reading) const { return (reading - middle_) / half_; }
  double half() const { return half_; }
  /// Variance of the slope of a signal at x.
  double slope_variance(Signal k, double x) const {
    const Vector s = slopes(x);
    return cubics_[k].variance * s.dot(inverse_ * s);
  }
  double value_variance(Signal k, double x) const {
    const Vector v = terms(x);
    return cubics_[k].variance * v.dot(inverse_ * v);
  }

 private:
  double variance(std::span<const PathSample> blocks, Signal k) const;

  double middle_ = 0, half_ = 1;
  Matrix inverse_;
  std::array<Cubic, PathSample::kSignals> cubics_;
};

Fit::Fit(std::span<const PathSample> blocks) {
  const double first = blocks.front().signal[Signal::reading];
  const double last = blocks.back().signal[Signal::reading];
  middle_ = (first + last) / 2;
  half_ = (last - first) / 2;
  Matrix normal = Matrix::Zero();
  std::array<Vector, PathSample::kSignals> right;
  right.fill(Vector::Zero());
  const auto& origin = blocks[blocks.size() / 2].signal;
  for (const PathSample& block : blocks) {
    const Vector t = terms(x_of(block.signal[Signal::reading]));
    normal += t * t.transpose();
    for (std::size_t k = 0; k < PathSample::kSignals; ++k)
      right[k] += (block.signal[k] - origin[k]) * t;
  }
  inverse_ = normal.ldlt().solve(Matrix::Identity());
  for (std::size_t k = 0; k < PathSample::kSignals; ++k) {
    cubics_[k].c = inverse_ * right[k];
    cubics_[k].c[0] += origin[k];
    cubics_[k].variance = variance(blocks, static_cast<Signal>(k));
  }
}

/// Residual variance times 1 + 2 Σ ρ_j over the lags before the correlation is first negative:
/// converters with coarse steps err alike in neighbouring blocks.
double Fit::variance(std::span<const PathSample> blocks, Signal k) const {
  std::vector<double> residual;
  residual.reserve(blocks.size());
  for (const PathSample& b : blocks)
    residual.push_back(b.signal[k] - cubics_[k].value(x_of(b.signal[Signal::reading])));
  const auto product = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < residual.size(); ++i) sum += residual[i] * residual[i - lag];
    return sum;
  };
  const double square = product(0);
  if (!(square > 0)) return 0;
  double correlated = 1;
  for (std::size_t lag = 1; lag < residual.size() / 4; ++lag) {
    const double rho = product(lag) / square;
    if (rho <= 0) break;
    correlated += 2 * rho;
  }
  return square / static_cast<double>(blocks.size() - kTerms) * correlated;
}

/// The witness, its slope along x and its variance.
struct Turn {
  double work = 0, slope = 0, variance = 0;
};

Turn turn_at(const Fit& fit, Witness witness, double x) {
  const auto shear = [](double axial, double volumetric) { return axial - volumetric / 3; };
  const Cubic &p = fit[Signal::p_eff], &q = fit[Signal::q];
  const double dp = p.slope(x), dq = q.slope(x);
  const double var_p = fit.slope_variance(Signal::p_eff, x);
  if (witness != Witness::second_order_work) {
    const auto k = witness == Witness::volume ? Signal::volumetric_strain : Signal::pore_pressure;
    const Cubic& gauge = fit[k];
    const double dg = gauge.slope(x);
    return {dp * dg, p.curvature(x) * dg + dp * gauge.curvature(x),
            dg * dg * var_p + dp * dp * fit.slope_variance(k, x)};
  }
  const Cubic &a = fit[Signal::axial_strain], &v = fit[Signal::volumetric_strain];
  const double dv = v.slope(x), dg = shear(a.slope(x), dv);
  const double var_a = fit.slope_variance(Signal::axial_strain, x);
  const double var_v = fit.slope_variance(Signal::volumetric_strain, x);
  const double of_volume = dp - dq / 3;  // ε_v enters ε_q, too
  return {dq * dg + dp * dv,
          q.curvature(x) * dg + dq * shear(a.curvature(x), v.curvature(x)) + p.curvature(x) * dv +
              dp * v.curvature(x),
          dg * dg * fit.slope_variance(Signal::q, x) + dv * dv * var_p + dq * dq * var_a +
              of_volume * of_volume * var_v};
}

/// The place nearest to `near_x` where the witness falls through zero.
std::optional<double> root_near(const Fit& fit, Witness witness, double near_x) {
  constexpr int kSteps = 64;
  std::optional<double> best;
  double a = -kEdge, work_a = turn_at(fit, witness, a).work;
  for (int i = 1; i <= kSteps; ++i) {
    const double b = -kEdge + 2 * kEdge * static_cast<double>(i) / kSteps;
    const double work_b = turn_at(fit, witness, b).work;
    if (work_a > 0 && work_b <= 0) {
      const double x = a + (b - a) * work_a / (work_a - work_b);
      if (!best || std::fabs(x - near_x) < std::fabs(*best - near_x)) best = x;
    }
    a = b;
    work_a = work_b;
  }
  return best;
}

PathPoint point_at(const Fit& fit, double x) {
  PathPoint p;
  p.reading = fit.reading(x);
  p.progress = fit[Signal::progress].value(x);
  p.q = fit[Signal::q].value(x);
  p.p_eff = fit[Signal::p_eff].value(x);
  p.axial_strain = fit[Signal::axial_strain].value(x);
  p.volumetric_strain = fit[Signal::volumetric_strain].value(x);
  p.pore_pressure = fit[Signal::pore_pressure].value(x);
  p.stress_variance =
      3 * fit.value_variance(Signal::p_eff, x) + fit.value_variance(Signal::q, x) * 2 / 3;
  p.window_readings = std::llround(2 * fit.half());
  return p;
}

}  // namespace

std::optional<OnsetFit> fit_onset(std::span<const PathSample> blocks, Witness witness,
                                  double near_reading) {
  constexpr std::size_t kLeastBlocks = 32;
  if (blocks.size() < kLeastBlocks) return std::nullopt;
  const Fit fit(blocks);
  const auto x = root_near(fit, witness, fit.x_of(near_reading));
  if (!x) return std::nullopt;
  const Turn turn = turn_at(fit, witness, *x);
  if (!(turn.slope < 0)) return std::nullopt;
  return OnsetFit{point_at(fit, *x), std::sqrt(turn.variance) / -turn.slope * fit.half(),
                  3 * fit[Signal::p_eff].variance + fit[Signal::q].variance * 2 / 3};
}

/// δη = (δq − η δp′)/p′ is a signal of its own: the cubics are linear in the signals.
StressFit stress_at(std::span<const PathSample> blocks, double reading) {
  const Fit first(blocks);
  const double x = first.x_of(reading);
  StressFit at{.q = first[Signal::q].value(x),
               .p_eff = first[Signal::p_eff].value(x),
               .error = {},
               .pore_pressure = first[Signal::pore_pressure].value(x),
               .p_rate = first[Signal::p_eff].slope(x) / first.half(),
               .pore_rate = first[Signal::pore_pressure].slope(x) / first.half(),
               .q_scatter = std::sqrt(first[Signal::q].variance),
               .pore_scatter = std::sqrt(first[Signal::pore_pressure].variance)};
  const double eta = at.q / at.p_eff;
  std::vector<PathSample> combined(blocks.begin(), blocks.end());
  for (PathSample& block : combined)
    block.signal[Signal::progress] = block.signal[Signal::q] - eta * block.signal[Signal::p_eff];
  at.error.q = std::sqrt(first.value_variance(Signal::q, x));
  at.error.p_eff = std::sqrt(first.value_variance(Signal::p_eff, x));
  at.error.eta = std::sqrt(Fit(combined).value_variance(Signal::progress, x)) / at.p_eff;
  return at;
}

PathPoint values_at(std::span<const PathSample> blocks, double reading) {
  const Fit fit(blocks);
  return point_at(fit, fit.x_of(reading));
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/uncertainty.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "src/study/student.hpp"

namespace triax::study {
namespace {

/// A parameter whose standard error is more than this share of its range, were every quantity of
/// every test wrong by kAccuracy of its span, is not determined.
constexpr double kOpenShare = 0.25;
constexpr double kWidest = 0.5;  // half width of an interval, of the range
constexpr double kAtBound = 1e-3;
constexpr double kFewestDegrees = 1;

/// One quantity of one test.
struct Series {
  Eigen::Index first = 0, count = 0;
  double variance = 0;     ///< of unweighted residuals, in units of s²
  double correlation = 0;  ///< ρ, from knot to knot
  double independent = 0;  ///< values that it is worth
};

std::vector<Series> series_of(const Misfit& misfit, const Eigen::VectorXd& r) {
  std::vector<Series> all;
  for (std::size_t t = 0; t < misfit.paths().size(); ++t) {
    const auto [first, rows] = misfit.rows(t);
    const auto& knots = misfit.paths()[t].knots;
    for (Eigen::Index q = 0; q < 2; ++q) {
      Series s{.first = first + q * rows / 2, .count = rows / 2};
      Eigen::VectorXd plain(s.count);
      for (Eigen::Index k = 0; k < s.count; ++k)
        plain(k) = r(s.first + k) / std::sqrt(knots[static_cast<std::size_t>(k)].weight);
      const double sum = plain.squaredNorm();
      s.variance = sum / static_cast<double>(s.count);
      const double lagged = plain.head(s.count - 1).dot(plain.tail(s.count - 1));
      const double rho = sum > 0 ? lagged / sum : 0;
      // White noise of n values gives ρ of 1/√n now and then, which is none.
      const double chance = 2 / std::sqrt(static_cast<double>(s.count));
      s.correlation = rho > chance ? std::min(rho, 0.98) : 0;
      s.independent =
          std::max(1.0, static_cast<double>(s.count) * (1 - s.correlation) / (1 + s.correlation));
      all.push_back(s);
    }
  }
  return all;
}

/// JᵀW R W J of one series, weighted slopes and weights given.
Eigen::MatrixXd spread_of(const Series& s, const Eigen::MatrixXd& slopes,
                          const Eigen::VectorXd& root_weights) {
  const Eigen::MatrixXd g =
      root_weights.segment(s.first, s.count).asDiagonal() * slopes.middleRows(s.first, s.count);
  // Σ_ij ρ^|i−j| g_i g_jᵀ by one sweep.
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(g.cols(), g.cols());
  Eigen::RowVectorXd behind = Eigen::RowVectorXd::Zero(g.cols());
  for (Eigen::Index k = 0; k < s.count; ++k) {
    sum += g.row(k).transpose() * g.row(k);
    const Eigen::MatrixXd cross = g.row(k).transpose() * behind;
    sum += cross + cross.transpose();
    behind = s.correlation * (behind + g.row(k));
  }
  return s.variance * sum;
}

/// g = JᵀW ∂r/∂e of each test, times the error.
Eigen::MatrixXd void_ratio_part(const Misfit& misfit, const Unknowns& x,
                                const Eigen::MatrixXd& slopes, const Eigen::VectorXd& values,
                                double error) {
  std::vector<MeasuredPath> moved = misfit.paths();
  for (MeasuredPath& path : moved) path.void_ratio += error;
  const Misfit other(misfit.space(), moved, misfit.threads(), misfit.driving());
  const Eigen::VectorXd change = other.residuals_of({x}).col(0) - values.head(slopes.rows());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(slopes.cols(), slopes.cols());
  for (std::size_t t = 0; t < moved.size(); ++t) {
    const auto [first, rows] = misfit.rows(t);
    const Eigen::VectorXd g =
        slopes.middleRows(first, rows).transpose() * change.segment(first, rows);
    sum += g * g.transpose();
  }
  return sum;
}

Eigen::VectorXd root_weights_of(const Misfit& misfit, Eigen::Index rows) {
  Eigen::VectorXd root(rows);
  Eigen::Index row = 0;
  for (const MeasuredPath& path : misfit.paths())
    for (int q = 0; q < 2; ++q)
      for (const PathKnot& knot : path.knots) root(row++) = std::sqrt(knot.weight);
  return root;
}

/// Of a matrix whose least eigenvalues may be round-off.
Eigen::MatrixXd inverted(const Eigen::MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a);
  const double least = 1e-13 * std::max(eigen.eigenvalues().maxCoeff(), 1e-300);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(least).cwiseInverse().asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// Which unknowns are determined: those that are not are taken out one by one, the worst first,
/// since one may only hide behind another.
std::vector<bool> determined(const Eigen::MatrixXd& a) {
  std::vector<bool> keep(static_cast<std::size_t>(a.rows()), true);
  for (;;) {
    std::vector<Eigen::Index> left;
    for (Eigen::Index i = 0; i < a.rows(); ++i)
      if (keep[static_cast<std::size_t>(i)]) left.push_back(i);
    if (left.empty()) return keep;
    const Eigen::MatrixXd part = a(left, left);
    const Eigen::MatrixXd inverse = inverted(part);
    Eigen::Index worst = 0;
    const double variance = inverse.diagonal().maxCoeff(&worst);
    if (std::sqrt(variance) <= kOpenShare) return keep;
    keep[static_cast<std::size_t>(left[static_cast<std::size_t>(worst)])] = false;
  }
}

}  // namespace

Uncertainty uncertainty_at(const Misfit& misfit, const Unknowns& x,
                           const UncertaintyOptions& options) {
  const SearchSpace& space = misfit.space();
  const Eigen::Index n = x.size();
  const Residuals at = residuals_with_slopes(misfit, x);
  const Eigen::Index tests = at.values.size() - 2 * n;
  const Eigen::MatrixXd slopes = at.jacobian.topRows(tests);
  const Eigen::MatrixXd priors = at.jacobian.bottomRows(n);
  const Eigen::MatrixXd a = slopes.transpose() * slopes + priors.transpose() * priors;
  const auto keep = determined(a);

  Uncertainty found;
  const auto series = series_of(misfit, at.values);
  double independent = 0;
  for (const Series& s : series) independent += s.independent;
  const auto free = static_cast<double>(n);
  found.degrees_of_freedom = std::max(independent - free, kFewestDegrees);
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(n, n);
  const Eigen::VectorXd root = root_weights_of(misfit, tests);
  for (const Series& s : series) b += spread_of(s, slopes, root);
  b *= independent / found.degrees_of_freedom;
  b += priors.transpose() * priors;
  if (options.void_ratio_error > 0)
    b += void_ratio_part(misfit, x, slopes, at.values, options.void_ratio_error);

  const Eigen::MatrixXd inverse = inverted(a);
  found.covariance = inverse * b * inverse;
  found.correlation.setZero(n, n);
  const double wide = student_quantile(found.degrees_of_freedom, options.confidence);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double error = std::sqrt(std::max(found.covariance(i, i), 0.0));
    // A law that does not follow the tests may leave all of a range open, whatever its slopes.
    const bool known = keep[static_cast<std::size_t>(i)] && wide * error < kWidest;
    const auto& range = space.ranges()[static_cast<std::size_t>(i)];
    ParameterEstimate p{.key = range.key, .value = space.value(i, x(i))};
    p.error = error * space.slope(i, x(i));
    p.low = known ? space.value(i, std::max(x(i) - wide * error, 0.0)) : range.low;
    p.high = known ? space.value(i, std::min(x(i) + wide * error, 1.0)) : range.high;
    p.determined = known;
    p.at_bound = x(i) < kAtBound || x(i) > 1 - kAtBound;
    found.parameters.push_back(p);
    for (Eigen::Index j = 0; j < n; ++j) {
      const double scale = std::sqrt(found.covariance(i, i) * found.covariance(j, j));
      found.correlation(i, j) = i == j ? 1 : scale > 0 ? found.covariance(i, j) / scale : 0;
    }
  }
  return found;
}

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/parameter_draws.hpp"

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "sim/grains/state/random.hpp"

namespace triax::study {
namespace {

constexpr double kRangeVariance = 1.0 / 12;
constexpr int kMostTries = 400;  // for each point that is asked for

bool within(const Unknowns& x) { return x.minCoeff() >= 0 && x.maxCoeff() <= 1; }

/// L with L Lᵀ = C, of a matrix whose least eigenvalues may be round-off below 0.
Eigen::MatrixXd root_of(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(covariance);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace

Eigen::MatrixXd bounded_covariance(const Uncertainty& sure) {
  const Eigen::MatrixXd& c = sure.covariance;
  std::vector<Eigen::Index> open;
  for (std::size_t i = 0; i < sure.parameters.size(); ++i)
    if (!sure.parameters[i].determined) open.push_back(static_cast<Eigen::Index>(i));
  if (open.empty()) return c;
  const Eigen::MatrixXd across = c(Eigen::all, open);
  Eigen::MatrixXd sum = c(open, open);
  sum.diagonal().array() += kRangeVariance;
  const Eigen::MatrixXd less = c - across * sum.ldlt().solve(across.transpose());
  return (less + less.transpose()) / 2;
}

ParameterDraws draw_parameters(const SearchSpace& space, const Unknowns& x, const Uncertainty& sure,
                               int count, std::uint64_t seed) {
  const Eigen::MatrixXd root = root_of(bounded_covariance(sure));
  const boost::math::chi_squared chi(sure.degrees_of_freedom);
  sim::Random dice(seed);
  ParameterDraws draws;
  draws.points.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < kMostTries; ++i) {
      Unknowns z(x.size());
      for (double& entry : z) entry = dice.normal();
      const double of_chi = boost::math::quantile(chi, 1 - dice.uniform());
      const Unknowns y = x + std::sqrt(sure.degrees_of_freedom / of_chi) * (root * z);
      if (!y.allFinite() || !within(y)) {
        ++draws.outside;
      } else if (!space.possible(y)) {
        ++draws.refused;
      } else {
        draws.points.push_back(y);
        break;
      }
    }
  return draws;
}

}  // namespace triax::study

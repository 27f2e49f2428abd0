// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/driven_fit.hpp"

#include <cmath>

namespace triax::lab {
namespace {

constexpr double kBehind = 0.3;  ///< of the distance, over which normalised work is continued

}  // namespace

std::optional<double> DrivenFit::root() const {
  const double a = y[3], b = y[2], c = y[1];
  std::optional<double> best;
  const auto take = [&](double xi) {
    if (!(b + 2 * a * xi < 0) || !(xi > -1)) return;
    if (!best || std::fabs(xi) < std::fabs(*best)) best = xi;
  };
  if (std::fabs(a) * std::fabs(c) < 1e-12 * b * b) {
    take(-c / b);
    return best;
  }
  const double under = b * b - 4 * a * c;
  if (under < 0) return std::nullopt;
  const double s = -0.5 * (b + std::copysign(std::sqrt(under), b));
  take(s / a);
  if (s != 0) take(c / s);
  return best;
}

std::optional<double> DrivenFit::root_of_slope() const {
  if (!(y[1] > 0) || !(beside[1] < 0)) return std::nullopt;
  const double falls = y[2] / y[1] - beside[2] / beside[1] + 0.5 * distance / now;
  return falls < 0 ? std::optional(-1 / falls) : std::nullopt;
}

double DrivenFit::normalised_work(double xi) const {
  const double volume = at(y, xi), shear = at(beside, xi) + volume / 3;
  return volume / std::sqrt(volume * volume + 4.5 * shear * shear);
}

void DrivenFit::give_way(double c_g, double ratio, double sign) {
  const DrivenFit::Columns lateral = (3 * beside - sign * y) / (2 + 1 / ratio);
  fluid = c_g;
  taken = c_g * lateral[1] * lateral[1];
  y[1] -= taken;
  y[2] -= 2 * c_g * lateral[1] * lateral[2];
  y[3] -= c_g * lateral[2] * lateral[2];
}

double DrivenFit::work_along_path(double ratio, double sign) const {
  const double answer = sign * (y[1] + taken);
  const double radial = (3 * beside[1] - answer) / (2 + 1 / ratio);
  const double axial = answer + radial / ratio;
  const double strain = -0.5 * (sign / ratio + fluid * radial);
  return y[1] / std::sqrt((1 + 2 * strain * strain) * (axial * axial + 2 * radial * radial));
}

std::optional<double> DrivenFit::root_of_work() const {
  const double here = normalised_work(0), behind = normalised_work(-kBehind);
  const double p = 1 / now, p_behind = 1 / (now - kBehind * distance);
  const double slope = (behind - here) / (p_behind - p);
  const double p_there = p - here / slope;
  if (!(slope > 0) || !(p_there > 0)) return std::nullopt;
  return (1 / p_there - now) / distance;
}

double DrivenFit::error(double xi) const {
  const DrivenFit::Columns g{0, 1, xi, xi * xi};
  const double slope = y[2] + 2 * y[3] * xi;
  return distance * std::sqrt(std::max(0.0, g.dot(variance * g))) / std::fabs(slope);
}

std::optional<DrivenFit> fit_driven(const std::vector<PathMean>& means, std::size_t first,
                                    double now, double distance, int terms) {
  DrivenFit f{.now = now, .distance = distance};
  const auto count = static_cast<Eigen::Index>(means.size() - first);
  if (count < terms + 2) return std::nullopt;
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::ColMajor, 128, 4> a(count, 4);
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::ColMajor, 128, 2> b(count, 2);
  const PathMean& from = means[first];
  for (Eigen::Index i = 0; i < count; ++i) {
    const PathMean& m = means[first + static_cast<std::size_t>(i)];
    const double w = std::sqrt(m.readings);
    const double j0 = m.weighted[0] - from.weighted[0], j1 = m.weighted[1] - from.weighted[1],
                 j2 = m.weighted[2] - from.weighted[2];
    a.row(i) << w, w * j0, w * (j1 - now * j0) / distance,
        w * (j2 - now * (2 * j1 - now * j0)) / (distance * distance);
    b.row(i) << w * (m.y - from.y), w * (m.beside - from.beside);
  }
  DrivenFit::Columns scale = a.colwise().norm();
  for (int k = 0; k < terms; ++k)
    if (!(scale[k] > 0)) return std::nullopt;
  const auto used = (a.leftCols(terms) * scale.head(terms).cwiseInverse().asDiagonal()).eval();
  const Eigen::LDLT<Eigen::MatrixXd> normal(used.transpose() * used);
  if (!(normal.rcond() > 1e-13)) return std::nullopt;
  const Eigen::MatrixXd solution = normal.solve(used.transpose() * b);
  const double rest = (b.col(0) - used * solution.col(0)).squaredNorm();
  const Eigen::MatrixXd inverse = normal.solve(Eigen::MatrixXd::Identity(terms, terms)) *
                                  (rest / static_cast<double>(count - terms));
  for (int k = 0; k < terms; ++k) {
    f.y[k] = solution(k, 0) / scale[k];
    f.beside[k] = solution(k, 1) / scale[k];
    for (int l = 0; l < terms; ++l) f.variance(k, l) = inverse(k, l) / (scale[k] * scale[l]);
  }
  return f;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/odd_tests.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "src/study/soil/estimate.hpp"

namespace triax::study {
namespace {

constexpr double kChance = 0.1;
constexpr double kUsualTests = 10;
constexpr int kRounds = 4;  // slopes and weights in turn
/// Forms are weighed by Akaike's criterion, and open where they differ by no more.
constexpr double kPerNumber = 2, kOpen = 2;

struct Judged {
  double residual = 0, deviations = 0, chance = 1;
};

struct Fit {
  Eigen::VectorXd numbers;     ///< a, b_1, ...
  Eigen::MatrixXd covariance;  ///< for a factor of 1
  double sum = 0;              ///< Σ r²/v
  double criterion = 0;        ///< sum + Σ ln v + 2 p
  double degrees = 0;          ///< m − p
};

Eigen::VectorXd row_of(const JudgedPoint& p) {
  Eigen::VectorXd row(static_cast<Eigen::Index>(p.x.size()) + 1);
  row(0) = 1;
  for (std::size_t k = 0; k < p.x.size(); ++k) row(static_cast<Eigen::Index>(k) + 1) = p.x[k];
  return row;
}

double variance_of(const JudgedPoint& p, const Eigen::VectorXd& numbers) {
  double v = p.y_error * p.y_error + p.usual * p.usual;
  for (std::size_t k = 0; k < p.x.size(); ++k) {
    const double b = numbers(static_cast<Eigen::Index>(k) + 1);
    v += b * b * p.x_error[k] * p.x_error[k];
    if (k == 0) v += b * b * p.usual_of_x * p.usual_of_x;
  }
  return std::max(v, 1e-300);
}

/// 1/s² of each number: 0 for those of which nothing is known.
Eigen::VectorXd known_of(const JudgedForm& form) {
  Eigen::VectorXd known(static_cast<Eigen::Index>(form.usual_slopes.size()) + 1);
  known(0) = 0;
  for (std::size_t k = 0; k < form.usual_slopes.size(); ++k)
    known(static_cast<Eigen::Index>(k) + 1) = std::pow(form.usual_slopes[k], -2);
  return known;
}

std::optional<Fit> fitted(const JudgedForm& form) {
  const auto& points = form.points;
  const Eigen::VectorXd known = known_of(form);
  const auto m = static_cast<Eigen::Index>(points.size());
  const Eigen::Index p = (known.array() == 0).count();
  if (m <= p) return std::nullopt;
  Eigen::MatrixXd rows(m, known.size());
  Eigen::VectorXd y(m), v(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    rows.row(i) = row_of(points[static_cast<std::size_t>(i)]).transpose();
    y(i) = points[static_cast<std::size_t>(i)].y;
  }
  Fit fit{.numbers = Eigen::VectorXd::Zero(known.size()), .covariance = {}};
  for (int round = 0; round < kRounds; ++round) {
    for (Eigen::Index i = 0; i < m; ++i)
      v(i) = variance_of(points[static_cast<std::size_t>(i)], fit.numbers);
    const Eigen::MatrixXd weighted = v.cwiseInverse().asDiagonal() * rows;
    Eigen::MatrixXd sums = rows.transpose() * weighted;
    sums.diagonal() += known;
    const Eigen::FullPivLU<Eigen::MatrixXd> normal(sums);
    if (!normal.isInvertible()) return std::nullopt;
    fit.covariance = normal.inverse();
    fit.numbers = fit.covariance * (weighted.transpose() * y);
  }
  fit.sum = (y - rows * fit.numbers).cwiseAbs2().cwiseQuotient(v).sum();
  fit.criterion = fit.sum + v.array().log().sum() + kPerNumber * static_cast<double>(p);
  fit.degrees = static_cast<double>(m - p);
  return fit;
}

Judged beside(const JudgedPoint& point, const Fit& fit) {
  const double degrees = fit.degrees + kUsualTests;
  const double factor = (fit.sum + kUsualTests) / degrees;
  const Eigen::VectorXd row = row_of(point);
  const double variance = variance_of(point, fit.numbers) + row.dot(fit.covariance * row);
  Judged j;
  j.residual = point.y - row.dot(fit.numbers);
  j.deviations = j.residual / std::sqrt(factor * variance);
  j.chance = chance_beyond(j.deviations, degrees);
  return j;
}

JudgedForm without(const JudgedForm& form, const std::vector<bool>& out, std::size_t also) {
  JudgedForm left{.points = {}, .usual_slopes = form.usual_slopes};
  for (std::size_t i = 0; i < form.points.size(); ++i)
    if (!out[i] && i != also) left.points.push_back(form.points[i]);
  return left;
}

/// The test beside the others, in the open form in which it is least odd.
std::optional<Judged> judged(const std::vector<JudgedForm>& forms, const std::vector<bool>& out,
                             std::size_t i) {
  std::vector<std::pair<double, Judged>> found;
  for (const JudgedForm& form : forms) {
    const auto fit = fitted(without(form, out, i));
    if (!fit) return std::nullopt;
    found.emplace_back(fit->criterion, beside(form.points[i], *fit));
  }
  double best = found.front().first;
  for (const auto& [criterion, of] : found) best = std::min(best, criterion);
  std::optional<Judged> least;
  for (const auto& [criterion, of] : found)
    if (criterion <= best + kOpen && (!least || of.chance > least->chance)) least = of;
  return least;
}

}  // namespace

std::vector<OddTest> odd_tests(const std::vector<JudgedForm>& forms) {
  std::vector<OddTest> odd;
  const std::size_t count = forms.front().points.size();
  std::vector<bool> out(count, false);
  while (odd.size() < count / 3) {
    std::optional<Judged> worst;
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (out[i] || !forms.front().points[i].judged) continue;
      const auto j = judged(forms, out, i);
      if (j && (!worst || j->chance < worst->chance)) worst = j, at = i;
    }
    if (!worst || worst->chance * static_cast<double>(count - odd.size()) > kChance) break;
    odd.push_back({at, worst->residual, worst->deviations});
    out[at] = true;
  }
  return odd;
}

}  // namespace triax::study

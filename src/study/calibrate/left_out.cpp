// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/left_out.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/study/student.hpp"

namespace triax::study {
namespace {

constexpr double kConfidence = 0.90;
constexpr int kRefitIterations = 15;
constexpr double kPredictionStep = 2e-3;

/// η of the law with these unknowns; empty where it does not collapse.
std::optional<double> eta_at(const Misfit& misfit, const Unknowns& x, const MeasuredPath& path) {
  const Unknowns near = misfit.space().possible_near(x);
  const auto material = misfit.space().material(near, path.imposed);
  return material ? onset_eta(*material->axisymmetric, path, misfit.driving()) : std::nullopt;
}

/// Variance of a prediction from the covariance of the unknowns, and from the error of the void
/// ratio of the test itself.
double variance_of(const Misfit& misfit, const Unknowns& x, const Eigen::MatrixXd& covariance,
                   const MeasuredPath& path, double eta, double void_ratio_error) {
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(x.size());
  misfit.each(static_cast<std::size_t>(x.size()), [&](std::size_t k) {
    const auto i = static_cast<Eigen::Index>(k);
    if (covariance(i, i) == 0) return;
    Unknowns beside = x;
    beside(i) += x(i) + kPredictionStep > 1 ? -kPredictionStep : kPredictionStep;
    if (const auto other = eta_at(misfit, beside, path))
      slope(i) = (*other - eta) / (beside(i) - x(i));
  });
  double variance = slope.dot(covariance * slope);
  if (void_ratio_error > 0) {
    MeasuredPath moved = path;
    moved.void_ratio += void_ratio_error;
    if (const auto other = eta_at(misfit, x, moved)) variance += std::pow(*other - eta, 2);
  }
  return variance;
}

struct Single {
  Prediction told;
  double variance = 0;  ///< of parameters and measurement
  double degrees = 1;
};

Single predict(const Misfit& misfit, const Unknowns& x, std::size_t left, double void_ratio_error,
               const std::function<bool()>& go_on) {
  const MeasuredPath& path = misfit.paths()[left];
  std::vector<MeasuredPath> others = misfit.paths();
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(left));
  const Misfit rest(misfit.space(), others, misfit.threads(), misfit.driving());
  const auto refit = least_squares(rest, x, kRefitIterations, go_on);
  Single one{.told = {.id = path.test,
                      .test = path.name,
                      .measured = *path.onset_eta,
                      .measured_error = path.onset_eta_error,
                      .predicted = eta_at(misfit, refit.x, path)}};
  if (!one.told.predicted) return one;
  const auto sure = uncertainty_at(rest, refit.x, {.void_ratio_error = void_ratio_error});
  one.degrees = sure.degrees_of_freedom;
  one.variance =
      variance_of(misfit, refit.x, sure.covariance, path, *one.told.predicted, void_ratio_error) +
      path.onset_eta_error * path.onset_eta_error;
  return one;
}

/// What the predictions of the others scatter beyond their errors, and of how many it is known.
void widen(std::vector<Single>& all, std::size_t which) {
  double excess = 0;
  int count = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k == which || !all[k].told.predicted) continue;
    excess += std::pow(*all[k].told.predicted - all[k].told.measured, 2) - all[k].variance;
    ++count;
  }
  Single& one = all[which];
  const double beyond = count > 0 ? std::max(excess / count, 0.0) : 0;
  const double degrees = beyond > one.variance ? count : one.degrees;
  const double half = student_quantile(degrees, kConfidence) * std::sqrt(one.variance + beyond);
  one.told.low = *one.told.predicted - half;
  one.told.high = *one.told.predicted + half;
}

}  // namespace

std::vector<Prediction> predict_left_out(const Misfit& misfit, const Unknowns& x,
                                         double void_ratio_error,
                                         const std::function<bool(double)>& go_on) {
  std::vector<Single> all;
  const auto& paths = misfit.paths();
  if (paths.size() < 2) return {};
  for (std::size_t k = 0; k < paths.size(); ++k) {
    if (!paths[k].onset_eta) continue;
    const auto still = [&] {
      return go_on(static_cast<double>(k) / static_cast<double>(paths.size()));
    };
    if (!still()) break;
    auto one = predict(misfit, x, k, void_ratio_error, still);
    if (!still()) break;  // its refit may not have come to its end
    all.push_back(std::move(one));
  }
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].told.predicted) widen(all, k);
  std::vector<Prediction> told;
  for (const Single& one : all) told.push_back(one.told);
  return told;
}

}  // namespace triax::study

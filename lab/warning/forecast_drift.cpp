// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/forecast_drift.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

constexpr double kSpan = 0.5;        ///< of the distance, over which a forecast is forgotten
constexpr double kPrior = 0.7;       ///< spread of slopes among tests
constexpr double kLeastSpan = 0.02;  ///< of η

}  // namespace

void ForecastDrift::add(double now, double ahead, double error) {
  if (n_ > 0) {
    const double span = kSpan * std::max(std::fabs(ahead), kLeastSpan * now);
    const double kept = std::exp(-std::max(now - latest_, 0.0) / span);
    for (double* sum : {&n_, &x_, &y_, &xx_, &xy_, &variance_}) *sum *= kept;
  }
  latest_ = now;
  const double eta = now + ahead;
  n_ += 1, x_ += now, y_ += eta, xx_ += now * now, xy_ += now * eta, variance_ += error * error;
}

ForecastDrift::Slope ForecastDrift::slope() const {
  const double prior = kPrior * kPrior;
  const double spread = xx_ / n_ - x_ * x_ / (n_ * n_);
  if (!(spread > 1e-9)) return {0, kPrior};
  const double variance = variance_ / n_ / spread;
  const double share = prior / (prior + variance);
  return {share * (xy_ / n_ - x_ * y_ / (n_ * n_)) / spread, std::sqrt(share * variance)};
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/power_line.hpp"

#include <algorithm>
#include <cmath>

namespace triax::study {
namespace {

constexpr double kLeast = 0.05, kMost = 1.5, kStep = 0.01;

/// x = −(p′/p_r)^ξ, so that the slope is λ.
std::vector<FitPoint> raised(const std::vector<FitPoint>& points, double exponent) {
  std::vector<FitPoint> out = points;
  for (auto& p : out) {
    const double power = std::exp(exponent * (p.x - std::log(kPowerPressure_kPa)));
    p.x_error *= exponent * power;
    p.correlation = -p.correlation;
    p.x = -power;
  }
  return out;
}

struct Trial {
  double exponent = 0, sum = 0;
  LineFit line;
};

/// With one scatter for all exponents, that their sums can be compared.
std::vector<Trial> trials(const std::vector<FitPoint>& points, double scatter) {
  std::vector<Trial> all;
  for (double xi = kLeast; xi < kMost + kStep / 2; xi += kStep) {
    const auto raised_points = raised(points, xi);
    if (const auto line = fit_line_with_scatter(raised_points, scatter))
      all.push_back({xi, weighted_residuals(*line, raised_points), *line});
  }
  return all;
}

PowerLine held_line(const std::vector<FitPoint>& points, double exponent) {
  PowerLine power;
  power.exponent_held = true;
  power.line = *fit_line(raised(points, exponent));
  power.void_ratio = power.line.intercept();
  power.slope = power.line.slope();
  power.exponent = {exponent, 0, exponent, exponent, power.line.tests};
  return power;
}

void widen(Estimate& estimate, double middle, double half) {
  estimate.low = std::min(estimate.low, middle - half);
  estimate.high = std::max(estimate.high, middle + half);
}

PowerLine profile(const std::vector<Trial>& all, const Trial& best, double limit, double t) {
  PowerLine power;
  power.line = best.line;
  const int n = best.line.tests;
  const auto start = [n](double v) { return Estimate{v, 0, v, v, n}; };
  power.void_ratio = start(best.line.a);
  power.slope = start(best.line.b);
  power.exponent = start(best.exponent);
  for (const auto& trial : all) {
    if (trial.sum > limit) continue;
    widen(power.exponent, trial.exponent, kStep / 2);
    // Covariances as if the sum were n − 2, times what is left of the limit.
    const double factor = trial.sum / trial.line.degrees();
    const double left = factor > 0 ? (limit - trial.sum) / factor : 0;
    widen(power.void_ratio, trial.line.a, std::sqrt(left * trial.line.var_a));
    widen(power.slope, trial.line.b, std::sqrt(left * trial.line.var_b));
  }
  for (auto* e : {&power.void_ratio, &power.slope, &power.exponent})
    e->error = (e->high - e->low) / (2 * t);
  return power;
}

}  // namespace

double PowerLine::at(double p_eff_kPa) const {
  return line.at(-std::pow(p_eff_kPa / kPowerPressure_kPa, exponent.value));
}

std::optional<PowerLine> fit_power_line(const std::vector<FitPoint>& points,
                                        std::optional<double> exponent) {
  const auto log_linear = fit_line(points);
  if (!log_linear) return std::nullopt;
  if (exponent) return held_line(points, *exponent);
  const auto all = trials(points, log_linear->scatter);
  if (points.size() < 4 || all.empty()) return held_line(points, kUsualExponent);
  const Trial& best = *std::ranges::min_element(all, {}, &Trial::sum);
  const double degrees = static_cast<double>(points.size()) - 3, t = t_of_95(degrees);
  const double limit = best.sum * (1 + t * t / degrees);
  if (all.front().sum <= limit || all.back().sum <= limit) return held_line(points, kUsualExponent);
  return profile(all, best, limit, t);
}

}  // namespace triax::study

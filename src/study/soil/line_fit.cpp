// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/line_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace triax::study {
namespace {

/// So small an error of y, of its size, that weights stay finite where points have none.
constexpr double kLeastShare = 1e-9;

double y_variance(const FitPoint& p, double scatter) {
  const double least = kLeastShare * std::max(std::abs(p.y), 1e-3);
  return p.y_error * p.y_error + scatter * scatter + least * least;
}

double covariance(const FitPoint& p) { return p.correlation * p.x_error * p.y_error; }

double weight(const FitPoint& p, double slope, double scatter) {
  const double v =
      y_variance(p, scatter) + slope * slope * p.x_error * p.x_error - 2 * slope * covariance(p);
  return 1 / std::max(v, 1e-300);
}

struct Sums {
  double weight = 0, x = 0, y = 0;
};

Sums means(const std::vector<FitPoint>& points, double slope, double scatter) {
  Sums s;
  for (const auto& p : points) {
    const double w = weight(p, slope, scatter);
    s.weight += w;
    s.x += w * p.x;
    s.y += w * p.y;
  }
  s.x /= s.weight;
  s.y /= s.weight;
  return s;
}

/// How far the point that the line puts in place of the measured one lies from the mean along x.
double adjusted(const FitPoint& p, const Sums& mean, double slope, double scatter) {
  const double u = p.x - mean.x, v = p.y - mean.y;
  const double along_x = p.scatter_along_x * scatter * scatter;
  const double yy = y_variance(p, scatter) - along_x;
  const double xx = p.x_error * p.x_error + (slope == 0 ? 0 : along_x / (slope * slope));
  return weight(p, slope, scatter) * (u * yy + slope * v * xx - (slope * u + v) * covariance(p));
}

double ordinary_slope(const std::vector<FitPoint>& points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& p : points) x += p.x, y += p.y;
  x /= static_cast<double>(points.size());
  y /= static_cast<double>(points.size());
  for (const auto& p : points) xx += (p.x - x) * (p.x - x), xy += (p.x - x) * (p.y - y);
  return xy / xx;
}

double york_slope(const std::vector<FitPoint>& points, double scatter) {
  double b = ordinary_slope(points);
  for (int i = 0; i < 100; ++i) {
    const Sums mean = means(points, b, scatter);
    double above = 0, below = 0;
    for (const auto& p : points) {
      const double beta = adjusted(p, mean, b, scatter), w = weight(p, b, scatter);
      above += w * beta * (p.y - mean.y);
      below += w * beta * (p.x - mean.x);
    }
    const double next = above / below;
    if (!std::isfinite(next)) break;
    const bool done = std::abs(next - b) <= 1e-12 * std::abs(next);
    b = next;
    if (done) break;
  }
  return b;
}

/// The scatter with which `excess` (falling with it) is 0; 0 where it is below already.
double balancing_scatter(const std::function<double(double)>& excess, double largest) {
  if (excess(0) <= 0) return 0;
  double low = 0, high = largest;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (excess(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

double range_of_y(const std::vector<FitPoint>& points) {
  const auto [low, high] = std::ranges::minmax(points, {}, &FitPoint::y);
  return high.y - low.y;
}

}  // namespace

double LineFit::error_at(double x) const {
  return std::sqrt(std::max(var_a + 2 * x * cov_ab + x * x * var_b, 0.0));
}
Estimate LineFit::line_at(double x) const { return estimate(at(x), error_at(x), degrees(), tests); }
Estimate LineFit::slope() const { return estimate(b, std::sqrt(var_b), degrees(), tests); }
double LineFit::correlation() const {
  return var_a > 0 && var_b > 0 ? cov_ab / std::sqrt(var_a * var_b) : 0;
}

double weighted_residuals(const LineFit& line, const std::vector<FitPoint>& points) {
  double sum = 0;
  for (const auto& p : points) {
    const double r = p.y - line.at(p.x);
    sum += weight(p, line.b, line.scatter) * r * r;
  }
  return sum;
}

std::optional<LineFit> fit_line_with_scatter(const std::vector<FitPoint>& points, double scatter) {
  if (points.size() < 3) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(points, {}, &FitPoint::x);
  if (high.x - low.x <= 1e-9 * std::max(std::abs(low.x), std::abs(high.x))) return std::nullopt;
  LineFit fit{.scatter = scatter,
              .x_low = low.x,
              .x_high = high.x,
              .tests = static_cast<int>(points.size())};
  fit.b = york_slope(points, scatter);
  const Sums mean = means(points, fit.b, scatter);
  fit.a = mean.y - fit.b * mean.x;
  double x_bar = 0, spread = 0;
  for (const auto& p : points)
    x_bar += weight(p, fit.b, scatter) * (mean.x + adjusted(p, mean, fit.b, scatter));
  x_bar /= mean.weight;
  for (const auto& p : points) {
    const double u = mean.x + adjusted(p, mean, fit.b, scatter) - x_bar;
    spread += weight(p, fit.b, scatter) * u * u;
  }
  const double factor = weighted_residuals(fit, points) / fit.degrees();
  fit.var_b = factor / spread;
  fit.var_a = factor / mean.weight + x_bar * x_bar * fit.var_b;
  fit.cov_ab = -x_bar * fit.var_b;
  return fit;
}

std::optional<LineFit> fit_line(const std::vector<FitPoint>& points) {
  if (!fit_line_with_scatter(points, 0)) return std::nullopt;
  const auto excess = [&](double scatter) {
    const auto fit = fit_line_with_scatter(points, scatter);
    return weighted_residuals(*fit, points) - fit->degrees();
  };
  return fit_line_with_scatter(points, balancing_scatter(excess, range_of_y(points) + 1e-300));
}

std::optional<MeanFit> fit_mean(const std::vector<FitPoint>& points) {
  if (points.size() < 2) return std::nullopt;
  const double degrees = static_cast<double>(points.size()) - 1;
  const auto sum = [&](double scatter) {
    const double mean = means(points, 0, scatter).y;
    double q = 0;
    for (const auto& p : points) q += weight(p, 0, scatter) * (p.y - mean) * (p.y - mean);
    return q;
  };
  const double scatter =
      balancing_scatter([&](double s) { return sum(s) - degrees; }, range_of_y(points) + 1e-300);
  const Sums mean = means(points, 0, scatter);
  double variance = 0, squares = 0;
  std::vector<double> shares;
  shares.reserve(points.size());
  for (const auto& p : points) {
    const double share = weight(p, 0, scatter) / mean.weight, r = p.y - mean.y;
    shares.push_back(share);
    variance += share * share * r * r / std::max(1 - share, 1e-12);
    squares += share * share;
  }
  return MeanFit{estimate(mean.y, std::sqrt(variance), std::max(1 / squares - 1, 1.0),
                          static_cast<int>(points.size())),
                 scatter, std::move(shares)};
}

}  // namespace triax::study

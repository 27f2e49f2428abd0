// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/odd_tests.hpp"

#include <cmath>
#include <numeric>
#include <optional>

namespace triax::study {
namespace {

constexpr double kChance = 0.01;
constexpr double kUsualTests = 4;

struct Judged {
  double residual = 0, deviations = 0, chance = 1;
};

/// The point beside the fit through the others.
std::optional<Judged> judged(const FitPoint& point, const std::vector<FitPoint>& others,
                             FitKind kind, double usual) {
  double predicted = 0, line_variance = 0, scatter_squared = 0, slope = 0, own = 0;
  if (kind == FitKind::line) {
    const auto fit = fit_line(others);
    if (!fit) return std::nullopt;
    predicted = fit->at(point.x);
    line_variance = fit->error_at(point.x) * fit->error_at(point.x);
    scatter_squared = fit->scatter * fit->scatter;
    slope = fit->b;
    own = fit->degrees();
  } else {
    const auto fit = fit_mean(others);
    if (!fit) return std::nullopt;
    predicted = fit->mean.value;
    line_variance = fit->mean.error * fit->mean.error;
    scatter_squared = fit->scatter * fit->scatter;
    own = fit->mean.tests - 1;
  }
  const double degrees = own + kUsualTests;
  const double s2 = (own * scatter_squared + kUsualTests * usual * usual) / degrees;
  const double error2 = point.y_error * point.y_error +
                        slope * slope * point.x_error * point.x_error -
                        2 * slope * point.correlation * point.x_error * point.y_error;
  Judged j;
  j.residual = point.y - predicted;
  j.deviations = j.residual / std::sqrt(s2 + error2 + line_variance);
  j.chance = chance_beyond(j.deviations, degrees);
  return j;
}

}  // namespace

std::vector<OddTest> odd_tests(std::vector<FitPoint> points, FitKind kind, double usual) {
  std::vector<OddTest> odd;
  std::vector<std::size_t> index(points.size());
  std::iota(index.begin(), index.end(), std::size_t{0});
  const std::size_t most = points.size() / 3;
  while (odd.size() < most) {
    std::optional<Judged> worst;
    std::size_t at = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      auto others = points;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      const auto j = judged(points[i], others, kind, usual);
      if (j && (!worst || j->chance < worst->chance)) worst = j, at = i;
    }
    if (!worst || worst->chance * static_cast<double>(points.size()) > kChance) break;
    odd.push_back({index[at], worst->residual, worst->deviations});
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(at));
    index.erase(index.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return odd;
}

}  // namespace triax::study

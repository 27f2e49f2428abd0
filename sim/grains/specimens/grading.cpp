// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/specimens/grading.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/grains/state/random.hpp"

namespace triax::sim {
namespace {

/// y at x on a polyline; the largest y where x occurs more than once.
double along(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto above = std::upper_bound(xs.begin(), xs.end(), x);
  if (above == xs.begin()) return ys.front();
  if (above == xs.end()) return ys.back();
  const auto k = above - xs.begin();
  return ys[k - 1] + (ys[k] - ys[k - 1]) * (x - xs[k - 1]) / (xs[k] - xs[k - 1]);
}

}  // namespace

GradingCurve paper_grading() {
  return {{2e-3, 3e-3, 4e-3, 5e-3, 6e-3, 7e-3, 8e-3, 9.5e-3},
          {0.01, 0.09, 0.25, 0.50, 0.69, 0.90, 0.95, 1}};
}

void check(const GradingCurve& curve) {
  const auto &d = curve.diameter_m, &s = curve.share;
  if (d.empty() || d.size() != s.size())
    throw std::invalid_argument(
        "grading: as many shares as diameters, and at least one, are needed");
  for (std::size_t k = 0; k < d.size(); ++k) {
    if (!(d[k] > 0 && std::isfinite(d[k])))
      throw std::invalid_argument("grading: a diameter must be above 0");
    if (k > 0 && !(d[k] > d[k - 1])) throw std::invalid_argument("grading: diameters must ascend");
    if (!(s[k] >= (k > 0 ? s[k - 1] : 0)))
      throw std::invalid_argument("grading: fractions must ascend from 0 to 1");
  }
  if (s.back() != 1) throw std::invalid_argument("grading: the last fraction must be 1");
}

double diameter_at(const GradingCurve& curve, double share) {
  return along(curve.share, curve.diameter_m, share);
}

double share_at(const GradingCurve& curve, double diameter_m) {
  if (diameter_m < curve.diameter_m.front()) return 0;
  return along(curve.diameter_m, curve.share, diameter_m);
}

std::vector<double> draw_diameters(const GradingCurve& curve, int count, std::uint64_t seed) {
  check(curve);
  if (count < 1) throw std::invalid_argument("grading: a specimen has at least one grain");
  Random random(seed);
  std::vector<double> diameters;
  for (int k = 0; k < count; ++k)
    diameters.push_back(diameter_at(curve, (k + random.uniform()) / count));
  random.shuffle(diameters);
  return diameters;
}

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/shear_curve.hpp"

#include <algorithm>
#include <cmath>

namespace triax::study {
namespace {

constexpr double kSteps = 150, kTurnedBack = 5e-4, kPaPerKPa = 1e3;

struct StepSum {
  CurvePoint sum;
  double void_ratio = 0;
  int states = 0, void_ratios = 0;
};

bool usable(const lab::State& s) {
  return std::isfinite(s.strain.axial) && std::isfinite(s.q) && std::isfinite(s.p_eff) &&
         s.p_eff > 0;
}

bool sheared_in_extension(const std::vector<lab::State>& states) {
  const lab::State* largest = nullptr;
  for (const auto& s : states)
    if (usable(s) &&
        (largest == nullptr || std::abs(s.strain.axial) > std::abs(largest->strain.axial)))
      largest = &s;
  return largest != nullptr && largest->strain.axial < 0;
}

CurvePoint mean_of(const StepSum& g) {
  const double n = g.states;
  CurvePoint p{g.sum.axial_strain / n, g.sum.shear_strain / n, g.sum.volumetric_strain / n,
               g.sum.q_kPa / n,        g.sum.p_eff_kPa / n,    {}};
  if (g.void_ratios > 0) p.void_ratio = g.void_ratio / g.void_ratios;
  return p;
}

double largest_strain(const std::vector<lab::State>& states, double sign) {
  double largest = 0;
  for (const auto& s : states)
    if (usable(s)) largest = std::max(largest, sign * s.strain.axial);
  return largest;
}

}  // namespace

ShearCurve shear_curve(const std::vector<lab::State>& states, bool drained,
                       std::optional<double> void_ratio) {
  ShearCurve curve{.extension = sheared_in_extension(states), .points = {}};
  const double sign = curve.extension ? -1 : 1;
  const double largest = largest_strain(states, sign);
  if (largest <= 0) return curve;
  std::vector<StepSum> steps(static_cast<std::size_t>(kSteps) + 1);
  double front = 0;
  for (const auto& s : states) {
    if (!usable(s)) continue;
    const double strain = sign * s.strain.axial;
    if (strain < front - kTurnedBack) continue;
    front = std::max(front, strain);
    auto& step =
        steps[static_cast<std::size_t>(kSteps * std::sqrt(std::max(strain, 0.0) / largest))];
    const double volumetric =
        drained && std::isfinite(s.volumetric_strain) ? s.volumetric_strain : 0;
    ++step.states;
    step.sum.axial_strain += strain;
    step.sum.volumetric_strain += volumetric;
    step.sum.shear_strain += strain - sign * volumetric / 3;
    step.sum.q_kPa += sign * s.q / kPaPerKPa;
    step.sum.p_eff_kPa += s.p_eff / kPaPerKPa;
    const double e = std::isfinite(s.void_ratio) ? s.void_ratio
                     : void_ratio                ? *void_ratio - volumetric * (1 + *void_ratio)
                                                 : lab::kMissing;
    if (std::isfinite(e)) step.void_ratio += e, ++step.void_ratios;
  }
  for (const auto& step : steps)
    if (step.states > 0) curve.points.push_back(mean_of(step));
  std::ranges::sort(curve.points, {}, &CurvePoint::axial_strain);
  return curve;
}

std::optional<LocalFit> local_fit(const std::vector<double>& x, const std::vector<double>& y,
                                  double x0) {
  const auto n = static_cast<double>(x.size());
  if (n < 3) return std::nullopt;
  double mx = 0, my = 0, xx = 0, xy = 0, rr = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mx += x[i] / n, my += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i)
    xx += (x[i] - mx) * (x[i] - mx), xy += (x[i] - mx) * (y[i] - my);
  if (xx <= 0) return std::nullopt;
  const double slope = xy / xx;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double r = y[i] - my - slope * (x[i] - mx);
    rr += r * r;
  }
  const double s2 = rr / (n - 2);
  return LocalFit{my + slope * (x0 - mx), slope,
                  std::sqrt(s2 * (1 / n + (x0 - mx) * (x0 - mx) / xx)), std::sqrt(s2 / xx)};
}

}  // namespace triax::study

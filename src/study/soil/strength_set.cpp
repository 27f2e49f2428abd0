// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/strength_set.hpp"

#include <algorithm>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::study {
namespace {

constexpr double kRepeatability = 0.02;

double angle_of(double k) {
  return sim::degrees(std::asin(std::clamp((k - 1) / (k + 1), -1.0, 1.0)));
}

Estimate angle(const Estimate& k) {
  const double slope = (angle_of(k.value + 1e-6) - angle_of(k.value)) / 1e-6;
  return {angle_of(k.value), slope * k.error, angle_of(std::max(k.low, 0.0)), angle_of(k.high),
          k.tests};
}

Estimate cohesion(const LineFit& fit) {
  const double k = std::max(fit.b, 1e-6), root = std::sqrt(k);
  const double by_a = 1 / (2 * root), by_k = -fit.a / (4 * k * root);
  const double variance =
      by_a * by_a * fit.var_a + by_k * by_k * fit.var_b + 2 * by_a * by_k * fit.cov_ab;
  return estimate(fit.a / (2 * root), std::sqrt(std::max(variance, 0.0)), fit.degrees(), fit.tests);
}

std::optional<Estimate> angle_without_cohesion(const std::vector<MohrCircle>& circles) {
  std::vector<FitPoint> ratios;
  ratios.reserve(circles.size());
  for (const auto& c : circles) ratios.push_back({0, c.major_kPa / c.minor_kPa, 0, 0, 0});
  const auto mean = fit_mean(ratios);
  return mean ? std::optional(angle(mean->mean)) : std::nullopt;
}

std::optional<TestPoint> reached_critical_state(const TestPoints& test) {
  if (test.critical.kind != CriticalKind::reached || !test.end) return std::nullopt;
  TestPoint point = *test.end;
  point.p_eff_kPa = std::exp(test.critical.log_p.value);
  point.q_kPa = test.critical.eta.value * point.p_eff_kPa;
  return point;
}

}  // namespace

std::string_view to_string(FailureCriterion criterion) {
  switch (criterion) {
    case FailureCriterion::peak_stress_ratio:
      return "peak_stress_ratio";
    case FailureCriterion::axial_strain:
      return "axial_strain";
    case FailureCriterion::critical_state:
      return "critical_state";
    case FailureCriterion::peak_deviator_stress:
      break;
  }
  return "peak_deviator_stress";
}

FailureCriterion failure_criterion(const std::string& word) {
  if (word == "peak-q") return FailureCriterion::peak_deviator_stress;
  if (word == "peak-ratio") return FailureCriterion::peak_stress_ratio;
  if (word == "strain") return FailureCriterion::axial_strain;
  if (word == "critical-state") return FailureCriterion::critical_state;
  throw lab::BadInput("criterion '" + word +
                      "' is not valid; must be one of: peak-q, peak-ratio, strain, critical-state");
}

std::optional<TestPoint> failure_of(const TestPoints& test, FailureCriterion criterion,
                                    double strain) {
  if (criterion == FailureCriterion::peak_stress_ratio) return test.peak_eta;
  if (criterion == FailureCriterion::peak_deviator_stress) return test.peak_q;
  if (criterion == FailureCriterion::critical_state) return reached_critical_state(test);
  const auto at =
      std::ranges::find_if(test.path, [&](const auto& p) { return p.axial_strain >= strain; });
  return at == test.path.end() ? std::nullopt : std::optional(*at);
}

MohrCircle circle_of(const TestPoint& f, bool extension) {
  MohrCircle circle;
  const double side = extension ? -1 : 1;
  const double axial = f.p_eff_kPa + side * 2 * f.q_kPa / 3,
               radial = f.p_eff_kPa - side * f.q_kPa / 3;
  circle.major_kPa = std::max(axial, radial);
  circle.minor_kPa = std::min(axial, radial);
  return circle;
}

FitPoint strength_point(const MohrCircle& circle) {
  return {circle.minor_kPa, circle.major_kPa, 0, kRepeatability * circle.major_kPa, 0};
}

std::optional<StrengthSet> strength_set(std::vector<MohrCircle> circles,
                                        FailureCriterion criterion) {
  std::vector<FitPoint> points;
  points.reserve(circles.size());
  for (const auto& c : circles) points.push_back(strength_point(c));
  const auto line = fit_line(points);
  if (!line) return std::nullopt;
  StrengthSet set{criterion, std::move(circles), *line, cohesion(*line), angle(line->slope()), {}};
  if (set.cohesion_kPa.holds(0))
    set.friction_angle_without_cohesion_deg = angle_without_cohesion(set.circles);
  return set;
}

}  // namespace triax::study

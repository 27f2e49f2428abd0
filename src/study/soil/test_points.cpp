// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/test_points.hpp"

#include <algorithm>
#include <cmath>

namespace triax::study {
namespace {

constexpr double kPa = 1e-3;
/// Strain below which η of a test that begins at small stresses is mostly seating.
constexpr double kSeating = 5e-4;

TestPoint point_of(const CurvePoint& p) {
  return {p.axial_strain, p.q_kPa, p.p_eff_kPa, p.void_ratio};
}

template <class Value>
std::size_t largest_at(const std::vector<CurvePoint>& points, const Value& value) {
  std::size_t best = points.size();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].axial_strain > kSeating &&
        (best == points.size() || value(points[i]) > value(points[best])))
      best = i;
  return best;
}

/// The points around one, within a fifth of its strain, three on each side at least.
std::vector<CurvePoint> around(const std::vector<CurvePoint>& points, std::size_t i) {
  const double half = 0.2 * points[i].axial_strain;
  std::vector<CurvePoint> near;
  for (std::size_t j = 0; j < points.size(); ++j)
    if ((j + 3 >= i && j <= i + 3) ||
        std::abs(points[j].axial_strain - points[i].axial_strain) < half)
      near.push_back(points[j]);
  return near;
}

/// The slope of a straight line through the points around. Where they lie around the largest rate,
/// it is a mean of rates that are smaller than that one, and is not corrected for it.
std::optional<Estimate> dilatancy_at(const std::vector<CurvePoint>& points, std::size_t i) {
  std::vector<double> x, y;
  for (const auto& p : around(points, i))
    x.push_back(p.shear_strain), y.push_back(p.volumetric_strain);
  const auto fit = local_fit(x, y, points[i].shear_strain);
  if (!fit) return std::nullopt;
  return measured(fit->slope, std::max(fit->slope_error, 1e-4));
}

/// Least p′ with the valve closed, largest compaction with it open, where both fall and rise by
/// more than a hundredth (p′) or 10⁻⁴ (ε_v).
std::optional<TestPoint> phase_transformation(const std::vector<CurvePoint>& points, bool drained) {
  const auto measure = [&](const CurvePoint& p) {
    return drained ? p.volumetric_strain : -std::log(p.p_eff_kPa);
  };
  const std::size_t i = largest_at(points, measure);
  if (i == points.size()) return std::nullopt;
  const double least = drained ? 1e-4 : 0.01;
  const double top = measure(points[i]);
  if (top - measure(points.front()) < least || top - measure(points.back()) < least)
    return std::nullopt;
  return point_of(points[i]);
}

double least_q_after(const std::vector<CurvePoint>& points, std::size_t i) {
  double least = points[i].q_kPa;
  for (std::size_t j = i; j < points.size(); ++j) least = std::min(least, points[j].q_kPa);
  return least;
}

void add_onset(TestPoints& to, const ShearedTest& test) {
  to.collapse = test.collapse;
  if (!test.onset || !test.onset->eta()) return;
  const double eta = *test.onset->eta();
  double error = 0.005 * std::abs(eta);
  if (test.onset->interval)
    error = std::max((test.onset->interval->eta.high - test.onset->interval->eta.low) / 3.92, 1e-4);
  to.onset_eta = measured(std::abs(eta), error);
  to.onset_p_eff_kPa = *test.onset->p_eff_pa * kPa;
  to.onset_q_kPa = std::abs(*test.onset->q_pa) * kPa;
}

void add_peaks(TestPoints& to, const std::vector<CurvePoint>& points) {
  const std::size_t q = largest_at(points, [](const auto& p) { return p.q_kPa; });
  const std::size_t eta = largest_at(points, [](const auto& p) { return p.eta(); });
  if (q == points.size()) return;
  to.peak_q = point_of(points[q]);
  to.peak_eta = point_of(points[eta]);
  std::vector<double> x, y;
  for (const auto& p : around(points, eta)) x.push_back(p.axial_strain), y.push_back(p.eta());
  if (const auto fit = local_fit(x, y, points[eta].axial_strain))
    to.peak_eta_error = std::max(fit->at_error, 1e-4);
  // A largest value at the end is no peak.
  const bool passed = eta + 2 < points.size();
  if (to.drained && passed) to.dilatancy_at_peak = dilatancy_at(points, eta);
  if (q + 2 < points.size() && to.peak_q->q_kPa > 0)
    to.brittleness = 1 - least_q_after(points, q) / to.peak_q->q_kPa;
  if (!to.drained && to.p_eff_kPa) to.strength_ratio = to.peak_q->q_kPa / (2 * *to.p_eff_kPa);
}

}  // namespace

TestPoints test_points(const ShearedTest& test, double stress_error_kPa) {
  const bool drained = test.drainage == lab::Drainage::open;
  TestPoints points{.id = test.id,
                    .name = test.name,
                    .material = test.material,
                    .simulated = test.simulated,
                    .drained = drained,
                    .void_ratio = test.void_ratio,
                    .cyclic = test.cyclic};
  if (test.p_eff_pa) points.p_eff_kPa = *test.p_eff_pa * kPa;
  const ShearCurve curve = shear_curve(test.states, drained, test.void_ratio);
  points.extension = curve.extension;
  add_onset(points, test);
  if (curve.points.size() < 5) {
    points.used = false;
    points.reason = "no shear stage with at least five strain steps of known stresses";
    return points;
  }
  if (!points.p_eff_kPa) points.p_eff_kPa = curve.points.front().p_eff_kPa;
  for (const auto& p : curve.points) points.path.push_back(point_of(p));
  points.end = points.path.back();
  if (test.cyclic) return points;  // its peaks are those of the load
  add_peaks(points, curve.points);
  points.phase_transformation = phase_transformation(curve.points, drained);
  points.critical = critical_state(curve, drained, stress_error_kPa);
  return points;
}

}  // namespace triax::study

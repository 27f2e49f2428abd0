// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_path_findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace triax::study {
namespace {

using Points = std::vector<sim::GrainPathPoint>;

/// Of the points with p above `least_p`.
template <class Value>
std::optional<GrainPeak> peak_of(const Points& points, double sense, const Value& value,
                                 double least_p = -std::numeric_limits<double>::infinity()) {
  std::optional<GrainPeak> peak;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].p_pa > least_p)) continue;
    const double here = value(points[i]);
    if (!peak || sense * here > sense * peak->value)
      peak = GrainPeak{i, here, points[i].strain.axial, false};
    else if (sense * (peak->value - here) > kFallen * std::abs(peak->value))
      peak->fell = true;
  }
  return peak;
}

std::optional<std::size_t> first_negative(const sim::GrainPath& path, const Points& points) {
  if (path.samples <= 0) return {};
  const std::size_t window = work_window(path.samples);
  if (points.size() <= window) return {};
  const std::size_t count = points.size() - window;
  std::size_t run = 0, seen = 0;
  for (std::size_t i = 0; i < count; ++i) {
    seen = i + 1;
    run = second_order_work(points[i], points[i + window], path.ratio) < 0 ? run + 1 : 0;
    if (run > window) break;
  }
  // At the end half of what is asked for has to do.
  const std::size_t last = std::min(count, seen);
  if (run < (window + 1) / 2) return {};
  return last - run + (window + 1) / 2;
}

}  // namespace

double second_order_work(const sim::GrainPathPoint& from, const sim::GrainPathPoint& to,
                         double ratio) {
  const double axial = to.strain.axial - from.strain.axial,
               radial = to.strain.radial - from.strain.radial,
               lateral_stress = to.stress.radial - from.stress.radial,
               control = to.stress.axial - from.stress.axial - lateral_stress / ratio;
  return control * axial + lateral_stress * (axial + 2 * ratio * radial) / ratio;
}

GrainPathFindings path_findings(const sim::GrainPath& path, const Points& points) {
  GrainPathFindings found;
  for (const auto& at : points)
    found.most_kinetic_j = std::max(found.most_kinetic_j, at.kinetic_energy_j);
  found.first_negative = first_negative(path, points);
  if (path.kind == sim::GrainPathKind::isotropic) return found;
  const double way =
      path.load_rate_pa_per_s != 0 ? path.load_rate_pa_per_s : path.strain_rate_per_s;
  const double sense = way < 0 ? -1 : 1;
  found.q = peak_of(points, sense, [](const auto& at) { return at.q_pa; });
  if (!points.empty())
    found.eta = peak_of(
        points, sense, [](const auto& at) { return at.stress_ratio(); },
        kMinP * points.front().p_pa);
  if (path.kind == sim::GrainPathKind::strain_path)
    found.path_stress = peak_of(points, sense, [](const auto& at) { return at.path_stress_pa; });
  return found;
}

}  // namespace triax::study

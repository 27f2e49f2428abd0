#include "src/report/grain_path_findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace triax::src {
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

std::optional<std::size_t> first_negative(const Points& points, double ratio) {
  const std::size_t window = work_window(points.size());
  if (points.size() <= window) return {};
  const std::size_t count = points.size() - window;
  std::size_t run = 0;
  for (std::size_t i = 0; i < count; ++i) {
    run = second_order_work(points[i], points[i + window], ratio) < 0 ? run + 1 : 0;
    if (run == 0 || (run <= window && i + 1 < count)) continue;
    return i + 1 - run + (window + 1) / 2;
  }
  return {};
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
  found.first_negative = first_negative(points, path.ratio);
  if (path.kind == sim::GrainPathKind::isotropic) return found;
  const double sense = path.strain_rate_per_s < 0 ? -1 : 1;
  found.q = peak_of(points, sense, [](const auto& at) { return at.q_pa; });
  if (!points.empty())
    found.eta = peak_of(
        points, sense, [](const auto& at) { return at.stress_ratio(); },
        kLeastP * points.front().p_pa);
  if (path.kind == sim::GrainPathKind::strain_path)
    found.path_stress = peak_of(points, sense, [](const auto& at) { return at.path_stress_pa; });
  return found;
}

}  // namespace triax::src

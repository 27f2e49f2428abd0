// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_curves.hpp"

#include <algorithm>
#include <cmath>

#include "src/study/grains/grain_path_findings.hpp"

namespace triax::study {
namespace {

void count_on(GrainCurve& curve, const sim::AxisymmetricStrain& before) {
  const auto shift = [&](sim::GrainPathPoint& point) {
    point.strain.axial += before.axial;
    point.strain.radial += before.radial;
    point.volumetric_strain += sim::volumetric_strain(before);
  };
  for (auto& point : curve.points) shift(point);
  for (auto& mark : curve.marks) shift(mark.at);
}

GrainCurve curve_of(const lab::ReportedGrainPath& came) {
  const GrainPathFindings found = path_findings(came.path, came.points);
  GrainCurve curve;
  curve.points = came.points;
  if (found.path_stress && found.path_stress->fell) {
    curve.peak = found.path_stress->point;
    curve.first_negative = found.first_negative;
  }
  for (const auto& mark : came.marks)
    if (mark.at) curve.marks.push_back({mark.name, *mark.at});
  return curve;
}

}  // namespace

std::vector<GrainCurve> curves_together(const std::vector<const lab::ReportedGrainStage*>& stages) {
  std::vector<GrainCurve> curves;
  const auto earliest =
      std::min_element(stages.begin(), stages.end(), [](const auto* a, const auto* b) {
        return std::abs(a->strain_before.axial) < std::abs(b->strain_before.axial);
      });
  for (const auto* stage : stages) {
    GrainCurve curve = curve_of(std::get<lab::ReportedGrainPath>(stage->came));
    const auto &here = stage->strain_before, &first = (*earliest)->strain_before;
    count_on(curve, {here.axial - first.axial, here.radial - first.radial});
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<std::optional<double>> works_along(const lab::ReportedGrainPath& path) {
  std::vector<std::optional<double>> works(path.points.size());
  for (std::size_t i = 1; i < works.size(); ++i)
    works[i] = second_order_work(path.points[i - 1], path.points[i], path.path.ratio);
  return works;
}

}  // namespace triax::study

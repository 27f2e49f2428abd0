// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/measured_span.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

void bound(double& value, const std::vector<PathSample>& readings, PathSample::Signal signal) {
  const auto [low, high] = std::ranges::minmax_element(
      readings, {}, [signal](const PathSample& one) { return one.signal[signal]; });
  if (!std::isnan(low->signal[signal]))
    value = std::clamp(value, low->signal[signal], high->signal[signal]);
}

}  // namespace

PathPoint within_measured(PathPoint point, const PathHistory& history) {
  const double reach = point.shortest_window() ? 1 : 3;
  const auto readings =
      history.between(std::ceil(point.reading) - reach, std::floor(point.reading) + reach);
  const bool single = std::ranges::all_of(readings, [](const PathSample& one) {
    return one.signal[PathSample::reading] == std::floor(one.signal[PathSample::reading]);
  });
  if (readings.size() < 2 || !single) return point;
  bound(point.q, readings, PathSample::q);
  bound(point.p_eff, readings, PathSample::p_eff);
  bound(point.axial_strain, readings, PathSample::axial_strain);
  bound(point.volumetric_strain, readings, PathSample::volumetric_strain);
  bound(point.pore_pressure, readings, PathSample::pore_pressure);
  return point;
}

}  // namespace triax::lab

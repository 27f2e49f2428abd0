// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/path_history.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {

void PathHistory::remember(Level& level, const PathSample& block) {
  if (level.ring.size() < kBlocks) {
    if (level.ring.empty()) level.ring.reserve(kBlocks);
    level.ring.push_back(block);
    return;
  }
  level.ring[level.next] = block;
  level.next = (level.next + 1) % kBlocks;
}

void PathHistory::add(const PathSample& sample) {
  last_ = sample.signal[PathSample::reading];
  if (!(first_ <= last_)) first_ = last_;
  PathSample block = sample;
  for (Level& level : levels_) {
    remember(level, block);
    level.half = !level.half;
    if (level.half) {
      level.first_half = block;
      return;
    }
    block = mean(level.first_half, block);
  }
}

bool PathHistory::reaches(const Level& level, double reading) {
  if (level.ring.size() < kBlocks) return true;  // it has forgotten nothing yet
  return level.ring[level.next].signal[PathSample::reading] <= reading;
}

std::vector<PathSample> PathHistory::between(double first_reading, double last_reading) const {
  const Level& level =
      *std::ranges::find_if(levels_, [=](const Level& one) { return reaches(one, first_reading); });
  const auto block = [&level](std::size_t i) -> const PathSample& {  // oldest first
    return level.ring[(level.next + i) % level.ring.size()];
  };
  std::size_t place = 0;
  for (std::size_t ahead = level.ring.size(); ahead > 0;) {
    const std::size_t half = ahead / 2;
    const bool before = block(place + half).signal[PathSample::reading] < first_reading;
    place += before ? half + 1 : 0;
    ahead = before ? ahead - half - 1 : half;
  }
  std::vector<PathSample> blocks;
  for (; place < level.ring.size() && block(place).signal[PathSample::reading] <= last_reading;
       ++place)
    blocks.push_back(block(place));
  return blocks;
}

namespace {

void bound_by(double& value, const std::vector<PathSample>& readings, PathSample::Signal signal) {
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
  bound_by(point.q, readings, PathSample::q);
  bound_by(point.p_eff, readings, PathSample::p_eff);
  bound_by(point.axial_strain, readings, PathSample::axial_strain);
  bound_by(point.volumetric_strain, readings, PathSample::volumetric_strain);
  bound_by(point.pore_pressure, readings, PathSample::pore_pressure);
  return point;
}

}  // namespace triax::lab

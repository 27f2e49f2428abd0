// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/path_history.hpp"

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

bool PathHistory::reaches(const Level& level, double reading) const {
  if (level.ring.size() < kBlocks) return true;  // it has forgotten nothing yet
  return level.ring[level.next].signal[PathSample::reading] <= reading;
}

std::vector<PathSample> PathHistory::between(double first_reading, double last_reading) const {
  std::vector<PathSample> blocks;
  for (const Level& level : levels_) {
    if (!reaches(level, first_reading)) continue;
    for (std::size_t i = 0; i < level.ring.size(); ++i) {
      const PathSample& block = level.ring[(level.next + i) % level.ring.size()];
      const double reading = block.signal[PathSample::reading];
      if (reading >= first_reading && reading <= last_reading) blocks.push_back(block);
    }
    break;
  }
  return blocks;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/block_pyramid.hpp"

#include <algorithm>

namespace triax::lab {

PathSample mean(const PathSample& first, const PathSample& second) {
  PathSample m;
  for (std::size_t k = 0; k < PathSample::kSignals; ++k)
    m.signal[k] = 0.5 * (first.signal[k] + second.signal[k]);
  return m;
}

void BlockPyramid::add(const PathSample& sample) {
  ++samples_;
  PathSample block = sample;
  closed_levels_ = 0;
  for (Level& level : levels_) {
    level.ring[level.next] = block;
    level.next = (level.next + 1) % kBlocks;
    level.count = std::min(level.count + 1, kBlocks);
    ++closed_levels_;
    level.half = !level.half;
    if (level.half) {
      level.first_half = block;
      return;
    }
    block = mean(level.first_half, block);
  }
}

const PathSample& BlockPyramid::block(int level, int i) const {
  const Level& l = levels_[level];
  return l.ring[(l.next + i) % kBlocks];
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A signal at every scale in constant memory: level L holds the means of the last few blocks of 2^L
// samples. A window of any length is then a handful of numbers, whatever the length of the record.
#include <array>
#include <cstddef>
#include <cstdint>

namespace triax::lab {

/// One sample of the measured path.
struct PathSample {
  enum Signal : std::size_t {
    reading,   ///< its number; a block's mean lies between readings
    progress,  ///< time (s), or path along the axial strain where there is no time
    q,
    p_eff,
    axial_strain,
    volumetric_strain,
    pore_pressure,
  };
  static constexpr std::size_t kSignals = 7;
  std::array<double, kSignals> signal{};
};

/// The block of twice the length.
PathSample mean(const PathSample& first, const PathSample& second);

class BlockPyramid {
 public:
  static constexpr int kBlocks = 7;   ///< blocks kept at each level
  static constexpr int kLevels = 40;  ///< 2^40 readings: more than any test has

  /// Adds one sample; afterwards closed_levels() tells how many levels got a new block.
  void add(const PathSample& sample);
  /// Levels 0 .. closed_levels() − 1 have just closed a block.
  int closed_levels() const { return closed_levels_; }
  /// True once level `level` holds kBlocks blocks.
  bool full(int level) const { return levels_[level].count >= kBlocks; }
  /// Block `i` of the level's window, 0 the oldest. Pre-condition: full(level).
  const PathSample& block(int level, int i) const;
  std::int64_t samples() const { return samples_; }
  void clear() { *this = BlockPyramid(); }

 private:
  struct Level {
    std::array<PathSample, kBlocks> ring{};
    int next = 0;   ///< slot of the oldest block, which the next one replaces
    int count = 0;  ///< blocks held, up to kBlocks
    bool half = false;
    PathSample first_half;  ///< waits for its sibling from the level below
  };
  std::array<Level, kLevels> levels_{};
  int closed_levels_ = 0;
  std::int64_t samples_ = 0;
};

}  // namespace triax::lab

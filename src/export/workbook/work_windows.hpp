// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which readings each stored point of second-order work rests on: seven blocks of 2^L readings
// (lab/measured/path_rates.hpp), found again by running over the states once more.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/measured/path_rates.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/measured/specimen_volume.hpp"
#include "lab/results/record_header.hpp"

namespace triax::src {

/// What stands in a block: means of its readings.
enum class BlockSignal { progress, q, p_eff, axial_strain, volumetric_strain };
inline constexpr std::size_t kBlockSignals = 5;
using Block = std::array<double, kBlockSignals>;  ///< s or strain, Pa, plain

/// The seven blocks of a point.
struct WorkWindow {
  std::int64_t reading = 0;  ///< beside which the point is stored
  int level = 0;             ///< blocks of 2^level readings
  std::size_t first = 0;     ///< of the seven, among the blocks of its level
  /// Blocks behind the middle one at which the parabolas are taken: 0, or up to 3 at the end.
  int offset = 0;
};

/// Blocks are counted over all stages at every level; each stage begins blocks of its own.
class WorkWindows {
 public:
  explicit WorkWindows(const lab::RecordHeader& header);
  WorkWindows(const WorkWindows&) = delete;
  WorkWindows& operator=(const WorkWindows&) = delete;

  /// Every state of the test in order; `row` is where it stands.
  void add(const lab::State& state, std::size_t row);
  void finish();

  /// In the order of their readings.
  const std::vector<WorkWindow>& windows() const { return windows_; }
  int levels() const { return static_cast<int>(blocks_.size()); }
  /// Level 0: the readings themselves.
  const std::vector<Block>& blocks(int level) const {
    return blocks_[static_cast<std::size_t>(level)];
  }
  /// Where the reading of a block of level 0 stands.
  std::size_t row(std::size_t block) const { return rows_[block]; }
  /// Of a block of level 1 or higher: the first of the two that it is the mean of.
  std::size_t first_half(int level, std::size_t block) const {
    return halves_[static_cast<std::size_t>(level)][block];
  }

 private:
  void take(const lab::PathPoint& point);
  double middle_of(const WorkWindow& window) const;
  void end_stage();
  void close_blocks(const Block& block, std::size_t row);

  lab::RecordHeader header_;
  lab::SpecimenVolume volume_;
  lab::PathSampler sampler_;
  lab::PathRates rates_;
  std::optional<int> stage_;
  bool ending_ = false;
  std::vector<WorkWindow> windows_;
  std::vector<std::vector<Block>> blocks_;
  std::vector<std::vector<std::size_t>> halves_;
  std::vector<std::size_t> begun_;      ///< blocks of each level before the stage under way
  std::vector<std::size_t> rows_;       ///< of blocks of level 0
  std::vector<std::int64_t> readings_;  ///< likewise
};

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The recent past of a path at every scale, in constant memory: level L remembers its last blocks
// of 2^L samples, so that far back the past is known in coarser steps.
#include <array>
#include <limits>
#include <vector>

#include "lab/measured/block_pyramid.hpp"
#include "lab/measured/path_rates.hpp"

namespace triax::lab {

class PathHistory {
 public:
  static constexpr std::size_t kBlocks = 256;  ///< remembered at each level
  static constexpr std::size_t kLevels = 40;

  void add(const PathSample& sample);
  void clear() { *this = PathHistory(); }

  /// The blocks that lie between two readings, oldest first, from the finest level that still
  /// reaches back to the first; fewer where the history begins later.
  std::vector<PathSample> between(double first_reading, double last_reading) const;
  /// Number of the first and last reading; NaN before any.
  double first_reading() const { return first_; }
  double last_reading() const { return last_; }

 private:
  struct Level {
    std::vector<PathSample> ring;  ///< at most kBlocks; allocated once the level is reached
    std::size_t next = 0;          ///< slot of the oldest block once the ring is full
    bool half = false;
    PathSample first_half;  ///< waits for its sibling from the level below
  };
  static void remember(Level& level, const PathSample& block);
  static bool reaches(const Level& level, double reading);

  std::array<Level, kLevels> levels_{};
  double first_ = kNone, last_ = kNone;
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
};

/// The point with its values, where a curve was fitted, within what the single readings around it
/// span: nothing was measured beyond. These are its two neighbours where a few readings were
/// enough for it, else the three on each side, among which noise lies on both sides of a fair
/// value. As it is where the history knows that part of the path in blocks only.
PathPoint within_measured(PathPoint point, const PathHistory& history);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Takes a material point along a path and isolates what happens on the way.
#include <functional>

#include "sim/point/path.hpp"
#include "sim/point/path_event.hpp"
#include "sim/point/point_driver.hpp"

namespace triax::sim {

/// The increment that could not be done, to be tried again by itself.
template <class Space>
struct FailedIncrement {
  PathPoint<Space> from;
  Segment<Space> segment;  ///< with the conditions of this part only; no end, no repetition
};

template <class Space>
struct PathResult {
  StepOutcome outcome = StepOutcome::accepted;
  std::string message;            ///< in words; empty when accepted
  std::string limiting_variable;  ///< label of the condition that was lost
  double error = 0;               ///< largest estimated error of an integration step, relative
  PathPoint<Space> last;          ///< where the path ended, whatever the outcome
  /// The first point of the largest |q|; empty where that stays below 1e-9 p′, round-off.
  std::optional<PathPoint<Space>> peak;
  std::vector<PathPoint<Space>>
      rows;  ///< the start, then the ends of the parts; last one at `last`
  std::vector<PathEvent<Space>> events;  ///< in the order of the path
  std::vector<std::string> warnings;     ///< of the law, each once
  std::optional<FailedIncrement<Space>> failed;
};

struct PathOptions {
  PointTolerance tolerance{.relative = 1e-8};
  /// Called with the share of the segments' parts that is done; returns false to stop the run,
  /// which then counts as failed.
  std::function<bool(double)> progress;
};

/// Runs the whole path, or as much of it as can be done. Events are isolated to 1e-10 of a part
/// of the segment. Throws std::invalid_argument as effective_control does and where the memory's
/// size is not the law's; every difficulty of the material is in the result.
template <class Space>
PathResult<Space> run_path(const Law<Space>& law, const Path<Space>& path,
                           const PathOptions& options = {});

}  // namespace triax::sim

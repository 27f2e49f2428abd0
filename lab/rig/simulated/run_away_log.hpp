// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Run-aways of the virtual specimen, for the truth of the test.
#include <vector>

#include "lab/results/record_header.hpp"
#include "sim/specimen/specimen.hpp"

namespace triax::lab {

class RunAwayLog {
 public:
  /// More than so many are not kept: a specimen that slips again and again.
  static constexpr std::size_t kMost = 100;

  /// The state after the tick that ended at `time_s`. `start`: the state in which a runaway that
  /// began in it did so; empty: not known. Returns a sentence where a runaway began or ended in
  /// it, else nothing.
  std::string watch(double time_s, const sim::SpecimenState& state,
                    const std::optional<Truth>& start = {});
  const std::vector<RunAwayTruth>& all() const { return all_; }

 private:
  std::vector<RunAwayTruth> all_;
  int seen_ = 0;  ///< run-aways that the specimen had had at the last tick
  bool running_ = false;
  bool follows_ = false;  ///< the one under way is kept
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One simulated test as a logger holds it, with the specimen's own truth.
#include <optional>
#include <vector>

#include "bench/detection/trial.hpp"
#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::bench {

struct SimulatedTest {
  lab::RecordHeader header;
  std::vector<lab::Reading> readings;
  std::vector<lab::State> states;  ///< reduced, one a reading
  /// Index of the first reading at or after the loss of sustainability; empty: there was none.
  std::optional<std::size_t> lost;
  std::size_t shear = 0;  ///< index of the first reading of shear
};

/// Runs the subject as bench/detection varies it. Empty where a specimen that was to collapse did
/// not, or no reading came after it did: there is nothing to compare with.
std::optional<SimulatedTest> simulate(const Subject& subject, std::uint64_t seed);

}  // namespace triax::bench

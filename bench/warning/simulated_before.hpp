// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the specimen's law says of a test before it is run: `triax simulate` with parameters as a
// calibration finds them, and the result told to the alarm (`--earlier`).
#include <cstdint>
#include <optional>

#include "bench/detection/trial.hpp"
#include "lab/warning/earlier_tests.hpp"

namespace triax::bench {

struct SimulatedBefore {
  static constexpr double kParameter = 0.005;  ///< standard error of each number of the law
  static constexpr double kVoidRatio = 0.005;  ///< and of the void ratio

  std::optional<double> eta;             ///< at the onset of the simulation
  std::optional<lab::EarlierTest> said;  ///< what it says to the test
};

/// The programme of that seed with the law's numbers and the void ratio off by what they are known
/// to, transducers without error, readings as close as the programme has them; B, stresses, rates,
/// rests and loops as they will be.
SimulatedBefore simulated_before(const Subject& subject, std::uint64_t seed);

}  // namespace triax::bench

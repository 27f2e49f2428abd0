// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Differential evolution (Storn and Price 1997), each trial going from its own member towards one
// of the best fifth (Zhang and Sanderson 2009).
#include <cstdint>
#include <functional>
#include <vector>

#include "src/study/calibrate/misfit.hpp"

namespace triax::study {

struct Candidate {
  Unknowns x;
  double sum = 0;  ///< Σ r²
};

struct GlobalOptions {
  std::uint64_t seed = 1;
  int members = 0;       ///< of the population; 0: six times the unknowns, 24 at least
  int generations = 40;  ///< at most; ends before where all members are alike
};

/// The last population, the best first. The same for the same seed, whatever the number of threads.
/// `progress` is told the share that is done and stops the search by false: what is best until then
/// is returned.
std::vector<Candidate> global_search(const Misfit& misfit, const GlobalOptions& options,
                                     const std::function<bool(double)>& progress);

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "lab/results/record_header.hpp"

namespace triax::study {

/// Where on its path a runaway begins: past a peak, where W₂ is already negative, or at a limit
/// point, where W₂ passes through 0 and the third order leads.
enum class RunawayStart { past_peak, limit_point };

/// What was measured of Eq. (5), 2 E_c = −W₂, over the first resolved increment of a runaway, and
/// how long the runaway took. Energies in J.
struct RunawayBalance {
  std::optional<double> half_work_j;  ///< −W₂/2, empty unless E_c is known too
  /// E_c / (−W₂/2). It tends to 1 as the increment shrinks from past a peak, to 2/3 from a limit
  /// point. Empty where either is unknown or W₂ is 0.
  std::optional<double> ratio;
  std::optional<RunawayStart> start;  ///< by the ratio that is expected; empty: none is
  double rise_s = 0;                  ///< from its start to the largest kinetic energy
  std::optional<double> duration_s;   ///< empty: still moving when the test ended
};

RunawayBalance balance_of(const lab::RunAwayTruth& runaway);

}  // namespace triax::study

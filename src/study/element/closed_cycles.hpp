// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Work that a path gets back for nothing. Over a closed cycle of stress ∮ σ′:dε is what the
// material takes; a law whose elastic stiffness has no energy (sim/materials/hyperelastic.hpp) can
// give instead, and does so again in every further cycle.
#include <optional>
#include <string>

#include "sim/point/path_runner.hpp"

namespace triax::study {

/// Per unit volume, J/m³.
struct ClosedCycle {
  std::size_t segment = 0;  ///< with which it ends
  double work = 0;          ///< ∮ σ′:dε, by the trapezoidal rule over the rows
  double exchanged = 0;     ///< ∮ |σ′:dε|
};

/// Of the cycles of at most 16 segments that come back to the effective stress (to 1e-6) at which a
/// segment began, the one with the least work. Cycles of fewer than 100 rows are left out: the sum
/// would not say it.
template <class Space>
std::optional<ClosedCycle> least_closed_cycle(const sim::PathResult<Space>& result);

/// What to tell of it; empty unless it gives back more than 0.2 % of what it exchanges.
std::optional<std::string> gain_in_words(const ClosedCycle& cycle, const std::string& segment);

extern template std::optional<ClosedCycle> least_closed_cycle(
    const sim::PathResult<sim::Axisymmetric>&);
extern template std::optional<ClosedCycle> least_closed_cycle(const sim::PathResult<sim::Tensor>&);

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The bifurcation domain as a map of the p′-q plane (section 4 of the paper).
#include <optional>
#include <vector>

#include "sim/stability/domain.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

/// The columns computed (all of the grid, or those of a piece of it) coloured inside the domain,
/// white where stable, pale blue where not all directions are answered and those that are are
/// stable, grey where the law has no state; on top the boundaries that are known, and
/// arrows for the first unstable stress direction. No plot without columns.
Drawing domain_figure(const sim::DomainGrid& grid, const std::vector<sim::DomainColumn>& columns,
                      const Subject& subject);

/// What colours a state: the opening of all its cones together, degrees; empty outside of the
/// domain.
std::optional<double> domain_value(const sim::DomainState& state);

}  // namespace triax::src

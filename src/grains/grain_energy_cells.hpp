// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where energy went, as cells of a table: of a stage or of a probe.
#include <string>
#include <vector>

#include "sim/grains/engine/grain_ledger.hpp"
#include "src/output/table.hpp"

namespace triax::src {

/// A table without rows whose first column is `first`; those of energy_cells() follow.
Table energy_columns(const std::string& first, Align align);
/// Work of the walls, changes of elastic and of kinetic energy, friction, damping, what was taken
/// out, J; the error as a share, and that of momentum.
std::vector<std::string> energy_cells(const sim::GrainLedger& ledger);

}  // namespace triax::src

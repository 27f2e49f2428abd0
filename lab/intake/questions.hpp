// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "lab/intake/proposal.hpp"

namespace triax::lab {

/// The facts that a result depends on and the file does not decide: units and signs of columns that
/// nothing states, day and month, dimensions of the specimen and pressures that no column or label
/// has.
std::vector<TableQuestion> find_questions(const Proposal& proposal);

/// True if no column is a pore pressure, an effective stress or a volume: a test in total stresses,
/// or a drained one.
bool is_without_pore_pressure(const Proposal& proposal);

}  // namespace triax::lab

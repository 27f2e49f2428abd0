// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>

#include "lab/results/quantity.hpp"

namespace triax::lab {

/// What a record needs for its second-order work: raw channels (axial displacement and force, cell
/// pressure) or, already reduced, the axial strain and two stress measures that give q and p'.
/// Empty if `columns` suffice, else one sentence that names what is there and what is missing.
std::string missing_channels(std::span<const Quantity> columns);

}  // namespace triax::lab

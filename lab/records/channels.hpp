// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>

#include "lab/results/quantity.hpp"

namespace triax::lab {

/// A record needs raw channels (axial displacement and force, cell pressure) or, already reduced,
/// the axial strain and two stress measures that give q and p'. A test in total stresses
/// (`total_stress`) needs no p'.
/// Empty if `columns` suffice, else one sentence that names what is there and what is missing, and
/// the key of --set that may give it.
std::string missing_channels(std::span<const Quantity> columns, bool total_stress = false);

/// True if a test in total stresses may have these columns, with a cell pressure that was held and
/// is in none of them: axial displacement and force, or axial strain and q or σ₁.
bool may_be_total_stress(std::span<const Quantity> columns);

}  // namespace triax::lab

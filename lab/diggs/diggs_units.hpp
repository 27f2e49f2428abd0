// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Units of measure (attribute uom) of DIGGS 2.6, which takes them from the Energistics unit of
// measure dictionary 1.0.
#include <optional>
#include <string_view>

#include "sim/mechanics/units.hpp"

namespace triax::lab {

/// The unit of that symbol ("kPa", "lbf/in2", "dega"); also other usual spellings. Empty text and
/// "Euc" mean a plain number. Nothing for a symbol that is unknown.
std::optional<sim::Unit> find_diggs_unit(std::string_view uom);

}  // namespace triax::lab

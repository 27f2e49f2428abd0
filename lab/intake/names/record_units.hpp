// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Units of the columns of a record, in the spellings of laboratories.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/mechanics/units.hpp"

namespace triax::lab {

/// The unit with that spelling and dimension: as in sim/mechanics/units.cpp, else as in
/// lab/intake/units.toml ("KN/m²", "hrs", "lbs"). Nothing for a unit of another dimension and for a
/// text that is no unit.
std::optional<sim::Unit> find_record_unit(std::string_view text, sim::Dimension dimension);

/// Names of the units of a dimension: "kPa", "Pa", "MPa", ...
std::vector<std::string> record_units(sim::Dimension dimension);
/// The same for messages: "kPa, Pa, MPa, ...".
std::string record_unit_names(sim::Dimension dimension);

}  // namespace triax::lab

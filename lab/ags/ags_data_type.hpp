// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace triax::lab {

/// Rule 8: whether a cell that is not empty is of that type: nDP, nSF, nSCI, U, YN, DT by the form
/// in `unit` (or cut shorter), T and DMS; true for the types of text.
bool fits_ags_type(std::string_view cell, std::string_view type, std::string_view unit);

/// The number as that type has it ("0DP", "2SF", "3SCI"); empty for what is unknown or no finite
/// number, which AGS4 leaves empty. A number that rounds to zero has no sign.
std::string ags_number(std::optional<double> value, std::string_view type);

}  // namespace triax::lab

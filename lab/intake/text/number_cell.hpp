// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

#include "lab/intake/text/cell_shape.hpp"

namespace triax::lab {

/// As parse_cell, of a cell in a number format that is known: also with thousands marks, the minus
/// sign of Unicode, brackets for a negative number and D in front of an exponent.
CellKind parse_number_cell(std::string_view cell, const NumberFormat& format, double& value);

}  // namespace triax::lab

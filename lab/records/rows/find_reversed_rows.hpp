// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "lab/base/byte_source.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_layout.hpp"

namespace triax::lab {

/// Sets layout.is_reversed and the last row of the layout, with a finding, if the first rows and,
/// without time, the last ones run back (RowOrder).
void find_reversed_rows(ByteSource& source, TableLayout& layout, Findings& findings);

/// The text with the rows in the order of the readings, if the rows of the layout are reversed.
std::unique_ptr<ByteSource> in_order(std::unique_ptr<ByteSource> text, const TableLayout& layout);

}  // namespace triax::lab

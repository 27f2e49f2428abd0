// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From the words of a heading line to quantities, units and signs.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/records/table_layout.hpp"

namespace triax::lab {

/// A heading without its unit in () or [], and that unit.
struct HeadingParts {
  std::string name;
  std::optional<std::string> unit;
};
HeadingParts split_heading(std::string_view heading);

/// How many of the cells are headings that the dialect understands.
std::size_t count_known(const Dialect& dialect, const std::vector<std::string_view>& cells);
/// True if one of the cells is a quantity in the form of the CSV format of triax.
bool has_own_heading(const std::vector<std::string_view>& cells);

/// Fills layout.columns and layout.cell_count. `units` is the row of units below the headings,
/// empty if there is none. A unit is taken from: true_unit of the dialect, heading, units row,
/// dialect. Gives one sentence for each heading of our own form of table in which nothing was
/// recognised (also noted as a finding). Throws BadInput: two columns for one quantity, unknown or
/// unfitting units.
std::vector<std::string> plan_columns(TableLayout& layout, std::string_view heading_line,
                                      const std::vector<std::optional<std::string>>& units,
                                      Findings& findings);

}  // namespace triax::lab

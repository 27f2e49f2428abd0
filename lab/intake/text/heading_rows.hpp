// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The lines above the rows of a table: names of the columns, their units, and what they belong to.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lab/intake/text/row_model.hpp"

namespace triax::lab {

struct HeadingRows {
  std::vector<std::size_t> lines;        ///< of the sample, ascending
  std::optional<std::size_t> unit_line;  ///< can be above `top` if it is named "units"
  std::size_t top = 0;                   ///< first line of names, units or what belongs to them
  /// Cells of each of `lines`, one per column; one list for names that are below each other.
  std::vector<std::vector<std::string>> cells;
  std::vector<std::string> units;  ///< one per column; empty without a unit line
  double coverage = 0;             ///< fraction of the used columns that have a name
};

/// Headings of the rows; `lines` is empty if there are none.
HeadingRows find_heading_rows(const TableSample& sample, const RowModel& rows);

/// True for text in the form of a unit: "kPa", "[mm]", "(kg/cm²)", "%".
bool has_unit_form(std::string_view cell);

}  // namespace triax::lab

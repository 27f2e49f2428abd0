// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds the table in a text file by its shape: separator, number format, headings, units, rows.
// Names and units of quantities are not needed.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/intake/text/table_sample.hpp"
#include "lab/records/cells/cell_extents.hpp"
#include "lab/records/cells/cells.hpp"

namespace triax::lab {

/// A table beside others.
struct TableBlock {
  std::size_t first_cell = 0;
  std::size_t cell_count = 0;
  std::string title;  ///< of the line above its headings; empty: none
};

/// Line numbers are from 1.
struct TableStructure {
  Separator separator = Separator::comma;
  DecimalMark decimal = DecimalMark::point;
  char thousands = 0;  ///< as NumberFormat::thousands
  std::vector<std::int64_t> heading_lines;
  std::int64_t unit_line = 0;  ///< 0: none
  std::int64_t first_row_line = 0;
  std::int64_t last_row_line = 0;  ///< 0: rows up to the end of the file
  /// Lines between the first and the last row that hold text in place of values: headings and units
  /// that are repeated, titles. Only those of the sample.
  std::vector<std::int64_t> repeated_heading_lines;
  std::vector<std::string> headings;         ///< one per column, without the comment mark
  std::vector<std::string> lowest_headings;  ///< of several lines only the lowest; else empty
  std::vector<std::string> units;            ///< one per column as written; empty: no line of units
  std::string comment;                       ///< lines that begin so are no rows; empty: none
  std::vector<std::string> preamble;         ///< lines above the headings
  std::vector<std::string> beside;           ///< lines of CSV in other worksheets of the file
  std::size_t column_count = 0;
  CellExtents extents;             ///< of cells with spaces between them; empty: other separators
  std::vector<TableBlock> blocks;  ///< of tables side by side; empty: one table
};

struct StructureResult {
  std::optional<TableStructure> structure;
  /// Why there is no structure ("only text", "one column"), or why it has no headings.
  std::string reason;
};

/// The structure that fits best of the largest table in the sample. Takes time in proportion to the
/// bytes of the sample.
StructureResult find_structure(const TableSample& sample);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The meaning of each cell of a row: settled once, by recognise_table()
// (lab/records/tables/table_recognition.hpp).
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/intake/cells/clock_format.hpp"
#include "lab/intake/names/labels.hpp"
#include "lab/records/cells/cell_extents.hpp"
#include "lab/records/dialect.hpp"
#include "lab/records/findings.hpp"

namespace triax::lab {

/// One of several tests of a table.
struct TableTest {
  std::size_t block = 0;                       ///< of tables side by side, from 1; 0: the only one
  std::int64_t first_line = 0, last_line = 0;  ///< of its rows; 0: as the table
  std::int64_t line_before = 0;                ///< last row of the test above it; 0: none
  std::string name;                            ///< "lines 6 to 41"
  std::string sheet{};                         ///< of a workbook with several; empty: the only one
};

/// A table that is read as one test holds several: find_tests()
/// (lab/records/tables/table_tests.hpp) finds where each begins.
struct SeveralTests : BadInput {
  using BadInput::BadInput;
};

struct PlannedColumn {
  std::size_t cell = 0;
  ColumnRole role = ColumnRole::quantity;
  Quantity quantity{};
  SourceQuantity source{};
  double scale = 1;                     ///< to SI, with the sign of the dialect
  std::string heading;                  ///< as in the file, UTF-8
  std::optional<ClockFormat> clock;     ///< of cells that are dates or times of day
  std::optional<DateOrder> date_order;  ///< given by the dialect
  bool holds_words = false;             ///< of a stage: its cells are names, not numbers
  std::string unit_fault;               ///< of a time: why it has no unit, an error without a clock
};

struct TableLayout {
  Dialect dialect;
  std::string file;
  std::vector<std::string> head;    ///< lines above the headings, UTF-8
  std::vector<std::string> beside;  ///< lines of other worksheets that can have labels, as CSV
  std::int64_t heading_line = 0;
  std::int64_t first_row_line = 0;         ///< first line that can hold a row
  std::int64_t last_row_line = 0;          ///< 0: rows up to the end of the file
  std::vector<std::int64_t> other_lines;   ///< between the rows, in their order: headings again
  std::vector<std::string> heading_texts;  ///< lines of headings and units: no rows anywhere
  /// The last reading is in first_row_line: the rows are read from last_row_line to it, which both
  /// are then known (lab/records/rows/reversed_rows.hpp).
  bool is_reversed = false;
  Separator heading_separator = Separator::comma;
  Separator separator = Separator::comma;
  std::size_t cell_count = 0;
  CellExtents extents;  ///< of aligned columns; empty: rows need cell_count cells
  /// Cells of a table beside others; block_cells is 0 for the only table.
  std::size_t first_cell = 0, block_cells = 0;
  std::vector<PlannedColumn> columns;
  std::vector<LabelValue> labels;  ///< of the lines above the headings, without a dialect
  std::string test;     ///< name of the test among those of the file; empty: the only one
  std::string ignored;  ///< which columns are, in one sentence each; empty if none is

  /// A time is also a date, a time of day or both.
  bool has(ColumnRole role) const;
  bool has(Quantity quantity) const;  ///< as a column or a constant of the dialect
  /// Those of the dialect, and pressures that `labels` state and no column or constant has: the
  /// back pressure beside Δu, or as the pore pressure of a test of a drained type; else the
  /// effective consolidation stress as the cell pressure, with a back pressure of 0.
  std::vector<RowConstant> constants() const;
  /// Columns, constants and what follows from them.
  std::vector<Quantity> quantities() const;
  RowCompletion completion() const;
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The columns of a table as samples: the first and last rows of the file as numbers and clocks.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lab/intake/cells/clock_format.hpp"
#include "lab/intake/meaning.hpp"
#include "lab/intake/text/structure.hpp"
#include "lab/intake/text/table_sample.hpp"

namespace triax::lab {

struct TableColumn {
  std::size_t position = 0;  ///< in a row, from 1
  std::string heading;       ///< as in the file, UTF-8
  std::string title;         ///< the heading without its unit
  ColumnSample sample;       ///< of at most kMeaningRows rows
  std::optional<ClockFinding> clock;
  std::vector<double> all;           ///< numbers of all rows of the sample, NaN where there is none
  std::vector<double> clock_values;  ///< s, of all rows if `clock` has a format
  std::vector<std::string> texts;    ///< of all rows, if they are no numbers and no clocks
  double first = 0, last = 0;  ///< as printed, of the first complete and the last row; may be NaN
  std::string first_cell, last_cell;
};

/// Rows that the meaning is decided from, evenly over the sample.
inline constexpr std::size_t kMeaningRows = 60;

/// At most kMeaningRows of the values, evenly over them.
std::vector<double> evenly(std::span<const double> values);

struct TableColumns {
  std::vector<TableColumn> columns;
  std::vector<std::int64_t> row_lines;  ///< of the sample
  /// Cells of columns of numbers that hold no value: line, position.
  std::vector<std::pair<std::int64_t, std::size_t>> missing;
};

/// Reads cells `first_cell` to `first_cell + count` of each row; all if count is 0.
TableColumns read_columns(const TableSample& sample, const TableStructure& structure,
                          const TableBlock& block);

}  // namespace triax::lab

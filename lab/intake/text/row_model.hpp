// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The lines of a text that are rows of a table, if its cells are apart by a given separator.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lab/intake/text/cell_shape.hpp"
#include "lab/intake/text/table_sample.hpp"

namespace triax::lab {

/// Most cells of a line that are looked at.
inline constexpr std::size_t kMaxCells = 4096;

/// The mark that makes a line a comment ("#", "//", "**"); empty: none. A mark is followed by a
/// letter, a digit or a blank, and is not the separator.
std::string_view comment_mark(std::string_view line, Separator separator);
/// The cells of a line, without its comment mark; at most kMaxCells.
std::vector<std::string_view> cells_of(std::string_view line, Separator separator);

/// True for the numbers of four columns or more, "1;2;3;4" and "(1);(2);(3);(4)".
bool is_numbering(std::string_view line, Separator separator);

/// A line in the shapes of its cells.
struct ShapedLine {
  std::vector<ShapedCell> cells;  ///< without empty cells at the end
  std::size_t cell_count = 0;     ///< with them
  std::size_t texts = 0, values = 0;
  std::size_t numbers = 0;  ///< values that are numbers or clocks
  bool is_comment = false;

  bool is_blank() const { return cells.empty(); }
  CellShape shape(std::size_t column) const {
    return column < cells.size() ? cells[column].shape : CellShape::empty;
  }
};

/// How often the cells of a column are of each kind.
struct ColumnProfile {
  double values = 0, empties = 0, texts = 0;
};

/// The rows that a separator gives.
struct RowModel {
  Separator separator = Separator::comma;
  NumberFormat format;
  std::size_t width = 0;  ///< number of columns, 0: no table
  std::vector<ShapedLine> lines;
  std::vector<ColumnProfile> profile;
  std::vector<char> is_row;         ///< per line of the sample
  std::size_t first = 0, last = 0;  ///< first and last row
  std::size_t single_values = 0;    ///< lines with one cell, a value
  double purity = 0;                ///< fraction of the cells in rows that are values in `format`
  double coverage = 0;              ///< fraction of the lines with text that are rows

  /// True for a column in which most cells are values.
  bool is_value_column(std::size_t column) const {
    return profile[column].values > profile[column].texts;
  }
  bool is_used(std::size_t column) const {
    return profile[column].values + profile[column].texts > 0;
  }
};

RowModel fit_rows(const TableSample& sample, Separator separator);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables with aligned columns and spaces between them, where a missing value is blank too: a cell
// of a line with too few cells is in the column with which it overlaps.
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace triax::lab {

/// Characters of a line that the cells of one column take: from `begin` to before `end`, from 0.
struct CellExtent {
  std::size_t begin = 0, end = 0;
};

/// The extents of `width` columns, from lines with that many cells.
class CellExtents {
 public:
  CellExtents() = default;
  explicit CellExtents(std::size_t width) : columns_(width) {}

  /// Pre-condition: the cells point into `line`, which is UTF-8. Ignores a line with another number
  /// of cells.
  void add(std::string_view line, const std::vector<std::string_view>& cells);
  /// Puts the cells of a line in their columns, with empty ones between them. False, and nothing is
  /// changed, if the columns of the table overlap, or if a cell overlaps no column, several, or
  /// that of another cell.
  bool place(std::string_view line, std::vector<std::string_view>& cells) const;

 private:
  std::optional<std::size_t> column_of(CellExtent cell) const;
  bool are_apart() const;
  std::vector<CellExtent> columns_;
};

}  // namespace triax::lab

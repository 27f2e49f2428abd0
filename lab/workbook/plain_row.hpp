// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A row of a sheet as nearly all are written, read without an XML parser: most of the time of a
// workbook would go there.
#include <cstddef>
#include <string_view>
#include <vector>

namespace triax::lab {

/// Reads a `row` element with cells `c`, each with an optional formula `f` and a value `v`, of
/// printable ASCII without entities. The XML parser reads anything else (texts in the cell,
/// comments, namespaces, spaces between elements).
class PlainRow {
 public:
  struct Cell {
    std::string_view place, style, type;  ///< its attributes r, s, t; empty where it has none
    std::string_view value;
    bool formula = false;
  };

  /// How many bytes from the first on are such a row; 0 where none begins there, or it does not
  /// end. What it holds lies in these bytes.
  std::size_t read(std::string_view bytes);
  std::string_view number() const { return number_; }
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  std::string_view number_;
  std::vector<Cell> cells_;
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Recognises a record file from its content and settles, once, which cell of a row is what.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/records/dialect.hpp"
#include "lab/records/findings.hpp"

namespace triax::lab {

struct PlannedColumn {
  std::size_t cell = 0;
  ColumnRole role = ColumnRole::quantity;
  Quantity quantity{};
  double scale = 1;     ///< to SI, with the sign of the dialect
  std::string heading;  ///< as in the file, UTF-8
};

struct TableLayout {
  Dialect dialect;
  std::string file;
  std::vector<std::string> head;  ///< lines above the headings, UTF-8
  std::int64_t heading_line = 0;
  std::int64_t first_row_line = 0;  ///< first line that can hold a row
  Separator heading_separator = Separator::comma;
  Separator separator = Separator::comma;
  std::size_t cell_count = 0;
  std::vector<PlannedColumn> columns;

  bool has(ColumnRole role) const;
  std::vector<Quantity> quantities() const;
};

/// Reads the head of `source` (at most kLongestHead lines). `forced` is the dialect the user named.
/// Throws BadInput: empty file, no dialect fits (lists the headings found), no row below the
/// headings, two columns for one quantity, unknown units, missing channels.
TableLayout recognise_table(ByteSource& source, const std::optional<Dialect>& forced,
                            Findings& findings);

inline constexpr std::size_t kLongestHead = 400;

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// AGS4, the transfer format of ground investigations: a file of groups, each a table with one row
// of headings, one of units, one of types and rows of data. What a group means is not known here.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/base/line_reader.hpp"

namespace triax::lab {

struct AgsHeading {
  std::string name;  ///< "TRET_CELL"
  std::string unit;  ///< as the UNIT row has it; empty for none
  std::string type;  ///< "0DP", "X", ...
};

struct AgsGroup {
  std::string name;  ///< "TRET"
  std::vector<AgsHeading> headings;
  std::int64_t unit_line = 0;  ///< 0: the group has no UNIT row
  std::int64_t type_line = 0;

  std::optional<std::size_t> find(std::string_view heading) const;
};

/// The rows of DATA of a file, one after the other, in constant memory. Cells are UTF-8: a line
/// that is not is taken as Windows-1252. Blank lines, a byte-order mark, empty cells behind the
/// last heading and the end mark of DOS are passed over.
class AgsReader {
 public:
  /// Reads `source` from its first byte.
  explicit AgsReader(ByteSource& source) : source_(source), lines_(source) {}

  /// To the next row; false at the end of the file. Throws BadInput "FILE:LINE: ..." for what is
  /// no AGS4 (AGS 3 too) and for what is broken: open quotes, rows without or before their
  /// headings, headings, units or types given twice, a wrong number of cells.
  bool next();

  const AgsGroup& group() const { return group_; }
  /// As many as the group has headings.
  const std::vector<std::string>& cells() const { return cells_; }
  /// The trimmed cell below that heading; empty where it is blank or the group has no such heading.
  std::string_view cell(std::string_view heading) const;
  std::int64_t line() const { return lines_.line_number(); }

  const std::string& file() const { return source_.name(); }
  /// Each once, in the order of the file, as far as it was read.
  const std::vector<std::string>& group_names() const { return names_; }
  /// The first line that was no UTF-8, 0 if there was none.
  std::int64_t recoded_line() const { return recoded_line_; }

 private:
  bool next_line(std::string_view& line);
  bool take(std::string_view line);
  void begin_group();
  void take_headings();
  void take_units_or_types(bool units);
  void require_headings(const std::string& row) const;
  void fit_cells(const std::string& row);
  [[noreturn]] void fail(const std::string& what) const;

  ByteSource& source_;
  LineReader lines_;
  AgsGroup group_;
  std::vector<std::string> cells_;
  std::vector<std::string> names_;
  std::string utf8_;
  std::int64_t recoded_line_ = 0;
  bool has_data_ = false;
};

/// Whether the file calls itself AGS: its first line that is not blank is a GROUP row or, in a file
/// whose name ends in .ags, another row of AGS4; or it is the `"**` of AGS 3, which AgsReader
/// refuses. Reads as far as that line; throws BadInput where that is no text.
bool looks_like_ags(ByteSource& source);

}  // namespace triax::lab

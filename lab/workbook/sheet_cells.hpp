// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The cells of a sheet as they come.
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lab/base/xml_stream.hpp"
#include "lab/workbook/plain_row.hpp"
#include "lab/workbook/workbook.hpp"

namespace triax::lab {

/// "B12" as column 1 (A is 0) and row 12; nothing for any other text, and beyond column XFD or row
/// 1048576, where no sheet ends later.
struct CellPlace {
  std::size_t column = 0;
  std::int64_t row = 0;
};
std::optional<CellPlace> cell_place(std::string_view address);
/// 0 is A, 26 is AA.
std::string column_name(std::size_t column);
inline constexpr std::size_t kMaxColumns = 16384;
inline constexpr std::int64_t kMaxRows = 1'048'576;

struct CellListener {
  std::function<void(std::int64_t row)> row;
  /// Not told of cells that are empty. A number is told as the file has it, a date as a clock shows
  /// it, a decimal comma of a number in a text cell as a point; a formula by the value that it came
  /// to when the file was saved.
  std::function<void(std::size_t column, std::string_view text)> cell;
  std::function<void()> end_row;
};

/// Tells one sheet from its first row to its last, in constant memory.
class SheetCells {
 public:
  /// The workbook has to outlive it.
  SheetCells(const Workbook& book, const SheetEntry& sheet, CellListener listener);
  /// A block of the file further; false at its end. Throws BadInput as XmlStream does, and on rows
  /// or columns that are none or run back, formulas without a value, shared texts that are not
  /// there.
  bool advance() { return stream_.advance(); }

 private:
  void start(std::string_view element, XmlAttributes attributes);
  void end(std::string_view element);
  void begin_row(std::string_view number);
  /// What stands in the tag of a cell; empty where nothing does.
  struct CellTag {
    std::string_view place, style, type;
  };
  void begin_cell(const CellTag& tag);
  void end_cell();
  std::size_t column_of(std::string_view text) const;
  std::size_t take_plain_rows(std::string_view bytes);
  std::string_view cell_text();
  std::string_view date_or_number();
  [[noreturn]] void fail(const std::string& what) const;

  enum class Kind : unsigned char { number, shared, text, boolean, error, iso_date };

  const Workbook& book_;
  std::string sheet_;
  CellListener listener_;
  PlainRow plain_;
  std::int64_t row_ = 0;
  std::string row_text_;  ///< as it stands in an address
  std::size_t column_ = 0, next_column_ = 0;
  Kind kind_ = Kind::number;
  CellStyle style_ = CellStyle::number;
  bool taken_ = false, formula_ = false;
  int phonetic_ = 0;
  std::string value_, written_;
  XmlStream stream_;
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A sheet of a workbook as the text of a table, so that everything reads it that reads CSV.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/intake/text/table_sample.hpp"
#include "lab/workbook/sheet_cells.hpp"
#include "lab/workbook/workbook.hpp"

namespace triax::lab {

/// What the worksheets of a workbook hold.
struct SheetRoles {
  std::vector<std::string> tests;   ///< names of those with readings, each of a test of its own
  std::vector<std::string> others;  ///< with readings of another form, or of a stage before shear
  std::vector<std::string> beside;  ///< lines of all other worksheets, which may have labels
};

/// Lines of cells apart by commas, in quotes where they hold one: line N is row N of the sheet.
/// Rows are as wide as the widest before them, since a sheet does not keep empty cells at the end
/// of one. A row that begins with # stands as it would in a text file. Memory does not grow with
/// the sheet.
class SheetSource : public ByteSource, public HasLinesBeside {
 public:
  /// `file` is where the workbook came from.
  SheetSource(std::shared_ptr<const Workbook> book, SheetEntry sheet,
              std::shared_ptr<ByteSource> file, std::shared_ptr<const SheetRoles> roles = {});

  const std::string& name() const override { return book_->name(); }
  /// Of the text, as far as can be said before it is read.
  std::uint64_t size() const override { return 2 * file_->size(); }
  std::size_t read(std::span<char> into) override;
  void rewind() override;
  ByteSource& file() override { return *file_; }

  const std::vector<std::string>& lines_beside() const override { return roles_->beside; }

  const SheetEntry& sheet() const { return sheet_; }
  /// Never null; empty if they were not searched for.
  const std::shared_ptr<const SheetRoles>& roles() const { return roles_; }
  const Workbook& book() const { return *book_; }

 private:
  void put_cell(std::size_t column, std::string_view text);
  void end_row();

  std::shared_ptr<const Workbook> book_;
  SheetEntry sheet_;
  std::shared_ptr<ByteSource> file_;
  std::shared_ptr<const SheetRoles> roles_;
  std::unique_ptr<SheetCells> cells_;
  std::string text_;  ///< that is not read yet, from at_ on
  std::size_t at_ = 0;
  std::int64_t line_ = 0;  ///< lines that are written
  std::size_t width_ = 0, columns_ = 0;
  bool remark_ = false;  ///< the row begins with #
};

/// The text of one cell, "Tabelle!B5"; empty where the cell is. Throws BadInput where there is no
/// such sheet or the address is none.
std::string cell_of(const Workbook& book, const std::string& reference);
/// Whether a text is a reference to a cell of a sheet: NAME!B5.
bool is_cell_reference(std::string_view text);

}  // namespace triax::lab

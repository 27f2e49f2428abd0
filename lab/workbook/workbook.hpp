// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A workbook (.xlsx): its sheets, and what all of them share.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/workbook/cell_style.hpp"
#include "lab/workbook/shared_texts.hpp"
#include "lab/workbook/zip_archive.hpp"

namespace triax::lab {

struct SheetEntry {
  std::string name;  ///< "Versuch01"
  std::string part;  ///< "xl/worksheets/sheet2.xml"
};

class Workbook {
 public:
  /// Reads all but the sheets. Throws BadInput for an archive that is no workbook, has macros, no
  /// sheet, or more shared text than 48 MB.
  explicit Workbook(ZipArchive archive);

  const std::string& name() const { return archive_.name(); }
  const ZipArchive& archive() const { return archive_; }
  /// Worksheets in their order, without those that are hidden.
  const std::vector<SheetEntry>& sheets() const { return sheets_; }
  /// The sheet of that name, as lab::matches_name compares. Throws BadInput with the names there
  /// are.
  const SheetEntry& sheet(const std::string& wanted) const;

  /// Without line ends and tabs. Nothing where there is no such text.
  std::optional<std::string_view> shared_text(std::size_t index) const;
  /// Of a cell's s="...".
  CellStyle style(std::size_t index) const;
  bool from_1904() const { return from_1904_; }

 private:
  void read_parts();
  void read_sheets(const std::string& part);
  void read_shared_texts(const std::string& part);
  void read_styles(const std::string& part);

  ZipArchive archive_;
  std::vector<SheetEntry> sheets_;
  SharedTexts texts_;
  std::vector<CellStyle> styles_;
  bool from_1904_ = false;
};

/// True if the file begins as a zip archive does.
bool looks_like_workbook(ByteSource& source);

}  // namespace triax::lab

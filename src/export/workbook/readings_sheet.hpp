// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Readings as a record in triax's own form (docs/reference/record-files.md): triax replay reads the
// workbook again as the same test, a simulated one as simulated.
#include <string>
#include <vector>

#include "db/store.hpp"
#include "src/export/workbook/book.hpp"

namespace triax::src {

class ReadingsSheet {
 public:
  explicit ReadingsSheet(const db::StoredTest& test);

  /// Title, metadata of the record, headings.
  void begin(Sheet& sheet, const std::string& title) const;
  void write(Sheet& sheet, std::size_t row, const lab::Reading& reading) const;
  /// How the record ended, from `row` on.
  void end(Sheet& sheet, std::size_t row) const;

  std::size_t first_row() const { return above_.size() + 2; }
  /// Readings that the sheet has rows for.
  std::size_t room() const { return kRowsOfSheet - first_row() - below_.size(); }

 private:
  lab::RecordHeader header_;
  std::vector<std::string> above_, below_;
};

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A file of AGS4 as a value: for small ones, and to write them.
#include <string>
#include <string_view>
#include <vector>

#include "lab/ags/ags_reader.hpp"

namespace triax::lab {

using AgsRow = std::vector<std::string>;  ///< as many cells as the table has headings

struct AgsTable {
  std::string name;
  std::vector<AgsHeading> headings;
  std::vector<AgsRow> rows;
};

struct AgsDocument {
  std::vector<AgsTable> tables;

  AgsTable* find(std::string_view name);
  const AgsTable* find(std::string_view name) const;
};

/// All of a file; a group without a row of DATA is left out. Throws BadInput as AgsReader does.
AgsDocument read_ags_document(ByteSource& source);

/// The bytes of the file: all cells in quotes, CR LF, a blank line behind each group. A document
/// that was read from such bytes gives them again.
std::string ags_text(const AgsDocument& document);

/// The text in the characters of rule 1 (ASCII, without line ends): umlauts and signs of the field
/// spelled out, "?" for anything else.
std::string ags_ascii(std::string_view utf8);

}  // namespace triax::lab

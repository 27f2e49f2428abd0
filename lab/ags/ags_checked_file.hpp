// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A file of AGS4 as the check of its rules sees it: rows as they stand, right or wrong.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lab/ags/ags_rules.hpp"

namespace triax::lab {

struct AgsCheckedRow {
  std::int64_t line = 0;
  std::vector<std::string> cells;  ///< without the descriptor
};

struct AgsCheckedGroup {
  std::string name;
  std::int64_t line = 0;  ///< of its GROUP row
  std::vector<std::string> headings, units, types;
  std::int64_t heading_line = 0, unit_line = 0, type_line = 0;
  std::vector<AgsCheckedRow> rows;  ///< as many cells as there are headings

  /// Place of a heading; the number of headings where it is not there.
  std::size_t place(std::string_view heading) const;
  bool has(std::string_view heading) const { return place(heading) < headings.size(); }
};

struct AgsCheckedFile {
  std::vector<AgsCheckedGroup> groups;
  AgsCheck check;

  const AgsCheckedGroup* find(std::string_view name) const;
  void find_wrong(std::string rule, std::int64_t line, std::string group, std::string text);
};

/// The rules that single lines keep or break: 1, 2a, 2b, 3, 4, 5, 6, 19, 19a. Rows that do not fit
/// their headings are told and left out of the groups.
AgsCheckedFile read_checked_file(ByteSource& source);

/// The rules that need a dictionary: 7, 8, 9, 10, 18, 19b.
void check_by_dictionary(AgsCheckedFile& file);
/// The rules about groups that a file has to have: 2, 11, 13 to 17, 20.
void check_needed_groups(AgsCheckedFile& file);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of AGS4 by the names of their headings.
#include <map>
#include <string>
#include <vector>

#include "lab/ags/ags_dictionary.hpp"
#include "lab/ags/ags_document.hpp"

namespace triax::study {

/// What a row says, by heading; what is not there is empty in the file.
using AgsCells = std::map<std::string, std::string>;

/// A heading of our own, which group DICT declares.
struct AgsUserHeading {
  std::string group;  ///< "TRET"
  lab::AgsDefinition definition;
  std::string description;
};
const std::vector<AgsUserHeading>& ags_user_headings();

/// The definition of a heading in a group, the dictionary's or ours. Null where there is none.
const lab::AgsDefinition* ags_heading(const std::string& group, const std::string& heading);

/// Group by group in the order of a delivery.
class AgsRows {
 public:
  /// Pre-condition: every heading is one of the group's. Key cells count as in rule 10a.
  void add(const std::string& group, AgsCells cells);
  /// The same, unless a row of the group has these keys already.
  void add_once(const std::string& group, AgsCells cells);
  bool has(const std::string& group) const { return rows_.contains(group); }
  const std::map<std::string, std::vector<AgsCells>>& all() const { return rows_; }

  /// All groups with rows: those headings that are keys, required, or filled in some row, in the
  /// order of the dictionary, ours behind.
  lab::AgsDocument document() const;

 private:
  std::map<std::string, std::vector<AgsCells>> rows_;
};

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rules of AGS4 (Format of Data, rules 1 to 20) held against a file.
#include <cstdint>
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"

namespace triax::lab {

struct AgsFinding {
  std::string rule;       ///< "10a"
  std::int64_t line = 0;  ///< of the file; 0: the file or the group as a whole
  std::string group;      ///< empty: none is meant
  std::string text;       ///< what was found and what is wanted, one sentence
};

struct AgsCheck {
  std::vector<AgsFinding> findings;
  /// Groups of the file that neither its DICT nor our dictionary has (ags_dictionary.hpp): of them
  /// only what can be said without a dictionary is.
  std::vector<std::string> unknown_groups;
};

/// Rules 1 (ASCII), 2, 2a, 2b, 3, 4, 5 and 6, 7, 8, 9, 10a, 10b, 10c, 11, 13 to 18, 19, 19a, 19b
/// and, of 20, that file sets are in group FILE; whether the files are there is not looked at. At
/// most kMostAgsFindings are kept. Holds the file in memory; throws BadInput where that is larger
/// than 64 MB or no text.
AgsCheck check_ags(ByteSource& source);
inline constexpr std::size_t kMostAgsFindings = 1000;

/// "line 12, rule 8, TRET: ...".
std::string in_words(const AgsFinding& finding);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What AGS4 4.1.1 says of the groups that triaxial tests are handed over in.
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

struct AgsDefinition {
  std::string heading;  ///< "TRET_CELL"
  std::string type;     ///< "0DP"
  std::string unit;     ///< "kPa"; empty for none
  bool key = false;
  bool required = false;
};

struct AgsGroupDefinition {
  std::string group;                    ///< "TRET"
  std::string parent;                   ///< "TREG"; empty for none
  std::vector<AgsDefinition> headings;  ///< in the order of rule 7

  /// Null where the group has no such heading.
  const AgsDefinition* find(std::string_view heading) const;
};

/// lab/ags/dictionary: PROJ, TRAN, UNIT, TYPE, ABBR, DICT, FILE, LOCA, SAMP, TREG, TRET, TRIG,
/// TRIT, CTRG, CTRC, CTRP and CTRD.
const std::vector<AgsGroupDefinition>& ags_dictionary();
/// Of the same groups, the headings that 4.2 has behind those of 4.1.1.
const std::vector<AgsGroupDefinition>& ags_added_in_4_2();
/// Null for a group that is not in it.
const AgsGroupDefinition* ags_definition(std::string_view group);

}  // namespace triax::lab

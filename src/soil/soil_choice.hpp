// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which tests are studied together.
#include <string>
#include <vector>

#include "src/study/soil/sheared_test.hpp"

namespace triax::src {

struct SoilChoice {
  std::vector<std::string> tests;  ///< ids or names; empty: all
  std::string where, group;        ///< SQL (db/choice/test_choice.hpp)
  std::string db = "triax.db";
};

struct SoilGroup {
  std::string name;
  std::vector<study::ShearedTest> tests;
};

/// Groups in the order of their names. Throws lab::BadInput where no test is left, where a group
/// has fewer than three, or where tests of several materials are in one.
std::vector<SoilGroup> chosen_groups(const SoilChoice& choice);

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which tests are studied together.
#include <functional>
#include <string>
#include <vector>

#include "src/study/soil/sheared_test.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::study {

struct SoilChoice {
  std::vector<std::string> tests;  ///< ids or names; empty: all
  std::string where, group;        ///< SQL (db/choice/test_choice.hpp)
  std::string db = "triax.db";
};

struct SoilGroup {
  std::string name;
  std::vector<ShearedTest> tests;
};

/// Groups in the order of their names. `look` is called before each test is read. Throws
/// lab::BadInput where no test is left, where a group has fewer than three, or where tests of
/// several materials are in one.
std::vector<SoilGroup> chosen_groups(
    const SoilChoice& choice, const std::function<void()>& look = [] {});

/// What the tests of each group say together, `look` called before each too. Throws as
/// chosen_groups() and study_soil() do.
std::vector<Soil> study_soils(
    const SoilChoice& choice, const SoilOptions& options,
    const std::function<void()>& look = [] {});

}  // namespace triax::study

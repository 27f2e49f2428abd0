// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "src/sheet/sheet.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// Tests of one soil, each file once: by the material they are of, those of total stresses (UU)
/// apart.
struct TestSet {
  std::string material;
  bool total_stress = false;
  std::vector<const SheetTest*> tests;
  std::size_t read_again = 0;  ///< beside them: readings of a file that was read again
};
std::vector<TestSet> test_sets(const std::vector<SheetTest>& tests);

/// One page of a set: specimens, Mohr circles with c′ and φ′, stress paths, curves of shear. Of
/// many tests the table says how their values spread, and figures show bands.
Sheet set_sheet(const TestSet& set);

}  // namespace triax::src

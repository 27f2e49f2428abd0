// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sheets of tests without consolidation, in total stresses (src/study/sheet/total_stress.hpp).
#include <vector>

#include "src/sheet/sheet.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// How the test was run, after the specimen: σ₃, rate, time to failure.
SheetBox total_stress_test_box(const SheetTest& test);
/// q_f, c_u, σ₁, σ₃ at failure.
SheetBox total_stress_failure_box(const SheetTest& test);
/// The specimen as built and after.
SheetBox total_stress_specimen_box(const SheetTest& test);

/// What stands between the head and the corrections of such a test's sheet.
std::vector<SheetRow> total_stress_rows(const SheetTest& test);

/// Of a set of such tests: the specimens, the circles of total stress and the mean c_u, q over ε₁.
std::vector<SheetRow> total_stress_set_rows(const std::vector<const SheetTest*>& tests);

}  // namespace triax::src

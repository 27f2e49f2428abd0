// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/sheet/sheet.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// One page of one test.
Sheet test_sheet(const SheetTest& test);

/// "Consolidated undrained triaxial test", by what is known of its drainage and control.
std::string kind_of_test(const SheetTest& test);
/// A test of constant shear: its largest q is a reading of a plateau, no failure.
bool holds_q(const db::StoredTest& test);
/// "at the largest q".
std::string failure_words(const study::SheetOptions& options);
/// What the signs in the figures are, for the foot of a sheet.
inline constexpr const char* kSheetLegend =
    "□ failure, ○ onset, ◇ loss of control, dotted: nothing was read between";
/// Where its values come from, for the foot of a sheet.
std::string sheet_footer(const db::StoredTest& test);

}  // namespace triax::src

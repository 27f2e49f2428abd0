// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The boxes of the sheet of one test.
#include "src/sheet/sheet.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

SheetBox head_box(const SheetTest& test);
SheetBox specimen_box(const SheetTest& test);
/// Cell and pore pressure by steps, B of each.
SheetBox saturation_box(const SheetTest& test);
/// Stresses, volume, t_100, c_v, the rate that follows and the one that was used.
SheetBox consolidation_box(const SheetTest& test);
SheetBox failure_box(const SheetTest& test);
SheetBox verdict_box(const SheetTest& test);
SheetBox deviations_box(const SheetTest& test);
SheetBox remarks_box(const SheetTest& test);

}  // namespace triax::src

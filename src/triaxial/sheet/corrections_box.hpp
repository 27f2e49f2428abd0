// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/sheet/sheet.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// Area, membrane, drains, piston: formula and values at failure, and what of them is in q.
SheetBox corrections_box(const SheetTest& test);

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/study/json_parts.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// The member "sheet" of the JSON document of a test: the values that its sheet has, by the failure
/// that was chosen and the words that were said.
study::Json sheet_json(const SheetTest& test);

}  // namespace triax::src

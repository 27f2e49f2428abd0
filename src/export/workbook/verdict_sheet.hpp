// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The answer of the three (collapse, none, not judged) as the store has it, with its evidence.
#include "src/export/workbook/book.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/triaxial/content.hpp"

namespace triax::src {

void write_verdict(Sheet& sheet, const db::StoredTest& test, const TestContent& content);

/// Whether a fact of the content is of the verdict; else it is of specimen and record.
bool is_of_verdict(const Fact& fact);

}  // namespace triax::src

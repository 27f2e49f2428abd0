// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A test as a workbook: specimen, stages, readings, states that follow from them by formulas,
// assessment and charts (docs/how-to/reports.md).
#include <string>

#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// Throws lab::BadInput where the test has more readings than a sheet has rows.
void refuse_longer_than_a_sheet(const db::Store& store, const db::StoredTest& test);

/// Writes the workbook; returns how many cells of states stand as numbers, because no formula comes
/// to what was stored.
std::size_t export_workbook(const db::Store& store, const study::TestResult& result,
                            const std::string& path);

}  // namespace triax::src

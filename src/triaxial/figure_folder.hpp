// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The figures of a report as files of their own.
#include <string>
#include <vector>

#include "src/study/triaxial/collapse_increment.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// Writes into `folder`, which is made where it does not exist, of each figure an SVG, a PNG and a
/// PDF:
///
///   TEST_stress_path, TEST_history, TEST_onset, TEST_alarm    of each test
///   TYPE_stress_paths, TYPE_shear_curves, TYPE_strains    of all tests of a type (ICU, CSD...)
///   collapse_points, stress_increments                    of all tests
///
/// TEST and TYPE are their names in small letters, what is no letter and no digit being '_', and
/// distinct as FileNames makes them: of two tests with one name the second has its id behind it. A
/// figure without data is left out. Gives
/// the prefixes written. Throws lab::BadInput, lab::WorkFailed.
std::vector<std::string> write_figures(const std::vector<study::TestResult>& tests,
                                       const std::vector<study::CollapseIncrement>& increments,
                                       const std::string& folder);

/// The figures of sheets in the same way: TEST_consolidation, TEST_q, TEST_u or TEST_volume,
/// TEST_eta, TEST_path, TEST_void_ratio.
void write_sheet_figures(const std::vector<SheetTest>& tests, const std::string& folder);

}  // namespace triax::src

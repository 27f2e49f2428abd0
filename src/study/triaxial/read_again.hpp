// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <set>
#include <vector>

#include "src/study/triaxial/test_result.hpp"

namespace triax::study {

/// Ids of the tests that statistics over `tests` leave out, because their file was read again: of
/// the readings of one file the latest that is complete counts, or the latest where none is, as in
/// the view counted_tests of the database.
std::set<std::int64_t> read_again(const std::vector<TestResult>& tests);

}  // namespace triax::study

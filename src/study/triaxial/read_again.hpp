// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "src/study/triaxial/test_result.hpp"

namespace triax::study {

/// Complete, id. Of what is the same test the greatest counts: the latest that is complete, or the
/// latest where none is.
using RankOfReading = std::pair<bool, std::int64_t>;

/// Ids of the tests that statistics over `tests` leave out, because their file was read again: of
/// the readings of one file the one of the greatest rank counts, as in the view counted_tests of
/// the database.
std::set<std::int64_t> read_again(const std::vector<const db::StoredTest*>& tests);
std::set<std::int64_t> read_again(const std::vector<TestResult>& tests);

}  // namespace triax::study

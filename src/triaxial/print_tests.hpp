// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// The text report without what would command a terminal or break a line: names come from files of
/// others.
std::string text_for_people(std::vector<study::TestResult> tests);

/// Reads the named tests back from the database and prints them as text or JSON: the one way in
/// which simulate, replay and report say what a test came to.
void print_tests(const std::string& db, const std::vector<std::int64_t>& ids, bool json);

/// Of the named tests what was said while they ran, as text or as one JSON document (an object for
/// one test, an array for several).
std::string live_document(const std::string& db, const std::vector<std::int64_t>& ids, bool json);

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tests of a database, a line or an object each.
#include <string>
#include <vector>

#include "db/catalogue.hpp"

namespace triax::src {

/// A table for a terminal, and a sentence about tests that statistics leave out.
std::string test_list_text(const std::vector<db::ListedTest>& tests);
/// An array with an object a test; keys as in the report, and `counted`.
std::string test_list_json(const std::vector<db::ListedTest>& tests);

/// "test 3 'NAME'".
std::string test_in_words(const db::ListedTest& test);

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/study/triaxial/test_result.hpp"
#include "src/triaxial/content.hpp"

namespace triax::src {

/// The summary table, then each test in full, as plain UTF-8 text for a terminal.
std::string text_report(const std::vector<study::TestResult>& tests);

/// One test in full, without the summary table.
std::string text_of_test(const study::TestResult& test);
std::string text_of(const TestContent& content);
/// Labels and lines that are known of them, two blanks in.
std::string facts_text(const std::vector<Fact>& facts);

}  // namespace triax::src

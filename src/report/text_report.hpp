#pragma once
#include <string>
#include <vector>

#include "src/report/reported_test.hpp"

namespace triax::src {

/// The summary table, then each test in full, as plain UTF-8 text for a terminal.
std::string text_report(const std::vector<ReportedTest>& tests);

/// One test in full, without the summary table.
std::string text_of_test(const ReportedTest& test);

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/plot/pages.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// The report on A4 pages, each with its number: the summary table with all collapse points, then
/// every test from a new page with its facts, criteria, figures, checks and warnings, then `more`
/// sections; without tests these alone. Figures are vectors. The file appears whole or not at all;
/// "-" stands for standard output. Throws lab::WorkFailed.
void pdf_report(const std::vector<study::TestResult>& tests, const std::string& path,
                const std::vector<PageSection>& more = {});

/// The bytes of that file.
std::string pdf_bytes(const std::vector<study::TestResult>& tests,
                      const std::vector<PageSection>& more = {});

}  // namespace triax::src

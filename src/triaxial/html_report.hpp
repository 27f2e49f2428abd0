// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// The whole report as one HTML file that needs nothing else: style and figures (SVG) are inside.
/// Summary table and all collapse points first, then each test with its facts, figures, criteria,
/// checks and warnings, then `more` sections. Reads on a phone, prints on A4. The text is also
/// well-formed XML.
std::string html_report(const std::vector<study::TestResult>& tests, const std::string& more = {});

}  // namespace triax::src

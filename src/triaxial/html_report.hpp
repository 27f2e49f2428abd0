// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/triaxial/sheet/report_sheets.hpp"

namespace triax::src {

/// The sheets as one HTML file that needs nothing else: style and figures (SVG) are inside. Sets
/// first, then each test, with its evidence where that is asked for, then `more` sections. A sheet
/// prints on a page of A4. The text is also well-formed XML.
std::string html_report(const ReportSheets& sheets, const std::string& more = {});

}  // namespace triax::src

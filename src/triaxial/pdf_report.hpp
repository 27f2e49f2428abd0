// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/plot/pages.hpp"
#include "src/triaxial/sheet/report_sheets.hpp"

namespace triax::src {

/// An A4 PDF document: the sheets of the sets, then one of each test, each followed by its evidence
/// where that is asked for; then `more`. Throws lab::WorkFailed.
std::string pdf_bytes(const ReportSheets& sheets, const std::vector<PageSection>& more = {});
/// The same as a file, which appears whole or not at all.
void pdf_report(const ReportSheets& sheets, const std::string& path,
                const std::vector<PageSection>& more = {});

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Records that lie in a workbook: which sheet holds the readings, and which cells more.
#include <memory>
#include <string>

#include "lab/base/byte_source.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_layout.hpp"
#include "lab/rig/recorded.hpp"

namespace triax::lab {

/// The source itself where it is text. Of a workbook the sheet of options.sheet, else of the
/// dialect (table.sheet), else the first whose headings are recognised. Throws BadInput where no
/// sheet is.
std::unique_ptr<ByteSource> sheet_or_text(std::unique_ptr<ByteSource> source,
                                          const RecordOptions& options);
/// The same of a file, whose archive is not held in memory.
std::unique_ptr<ByteSource> open_readings(const std::string& path, const RecordOptions& options);

/// What the dialect's keys say by cells ("Tabelle!B5") of a workbook; nothing for text. Other
/// sheets with a table that is recognised are named in a finding. A value that is not valid for its
/// key is left out with a finding.
void take_cells(RecordHeader& header, ByteSource& source, const TableLayout& layout,
                Findings& findings);

}  // namespace triax::lab

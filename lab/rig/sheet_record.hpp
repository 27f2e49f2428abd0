// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A record as UTF-8 text, from whatever file it is in: a text in its encoding, or a workbook, where
// it is one worksheet with some more cells.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "lab/base/byte_source.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_layout.hpp"
#include "lab/rig/recorded.hpp"

namespace triax::lab {

/// The dialect that the user named, if any. Throws BadInput as find_dialect() does.
std::optional<Dialect> named_dialect(const RecordOptions& options);
/// The named dialect, else the one remembered for the headings of the table, with a finding.
std::optional<Dialect> dialect_for(ByteSource& table, const RecordOptions& options,
                                   Findings& findings);

/// True for a file of TOML with a table [columns].
bool is_dialect(const std::filesystem::path& file);
/// The options with the dialect beside the record (RECORD.toml, is_dialect()), if none is named.
RecordOptions with_dialect_beside(const std::string& path, const RecordOptions& options);

/// A text as UTF-8. Its encoding is that of the options, else of the dialect (table.encoding), else
/// it is found. A workbook gives the worksheet that the options name, else the dialect, else that
/// of the test, else the first with headings that are recognised (SheetRoles). Throws BadInput for
/// a file that is no table (find_file_kind), an unknown encoding, and if no worksheet fits.
std::unique_ptr<ByteSource> sheet_or_text(std::unique_ptr<ByteSource> source,
                                          const RecordOptions& options);
/// The same of a file, whose archive is not held in memory.
std::unique_ptr<ByteSource> open_readings(const std::string& path, const RecordOptions& options);

/// A finding with the encoding of a text that is not UTF-8.
void note_encoding(const ByteSource& source, Findings& findings);

/// What the dialect's keys say by cells ("Tabelle!B5") of a workbook; nothing for text. Other
/// sheets with a table that is recognised are named in a finding. A value that is not valid for its
/// key is left out with a finding.
void take_cells(RecordHeader& header, ByteSource& source, const TableLayout& layout,
                Findings& findings);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Recognises a table from its content.
#include <cstddef>
#include <optional>

#include "lab/base/byte_source.hpp"
#include "lab/records/dialect.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_layout.hpp"

namespace triax::lab {

/// Reads the head of `source` (at most kMaxHead_lines lines), and rows if they have clocks
/// (clock_columns.hpp). `forced` is the dialect the user named. Throws BadInput: empty file, no
/// dialect fits (lists the headings found), no row below the headings, two columns for one
/// quantity, unknown units, missing channels, a date without the order that the dialect gives.
/// Missing channels of a test in total stresses or with a cell pressure that was held pass: its
/// metadata, which are not known here, may give the rest. `test` is one of find_tests(); without it
/// the table must hold one test (SeveralTests).
TableLayout recognise_table(ByteSource& source, const std::optional<Dialect>& forced,
                            Findings& findings, const TableTest& test = {});

inline constexpr std::size_t kMaxHead_lines = 400;

}  // namespace triax::lab

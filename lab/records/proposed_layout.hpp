// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table without a dialect, read by its proposal (lab/intake/proposal.hpp).
#include "lab/intake/proposal.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_layout.hpp"

namespace triax::lab {

/// The layout of the table. What was assumed is noted: columns that only the readings decide,
/// columns that are not used, s′ and t under the names p′ and q. Throws BadInput with the questions
/// that have to be answered first: a table without headings, a unit or meaning that nothing
/// decides, day and month of the only time. The rows are those of all tests of the table.
TableLayout layout_of(const Proposal& proposal, const std::string& file, Findings& findings);

/// The layout of a table whose dialect names columns by their place, or by the headings that the
/// structure has. Places count from the first table of those side by side; `block` is the one to
/// read, from 1, or 0. A unit of the dialect counts before that of the heading. Columns that are
/// not used are noted. Throws BadInput: no such column, an unknown or missing unit.
TableLayout layout_of(const Dialect& dialect, const TableStructure& structure, std::size_t block,
                      const std::string& file, Findings& findings);

/// Finds the labels above the table that its dialect does not have.
void take_labels(TableLayout& layout);
/// Lines between the rows of a test and those of the test above it, the first one with number
/// `line`: if they hold labels, these replace the labels above the table that are about its first
/// test. Those above the first line that the later test repeats are common to all tests. Pairs of a
/// name and a value directly below the rows of the test above are about that test.
void take_labels_between(TableLayout& layout, std::vector<std::string> lines, std::int64_t line);
/// Lines directly below the rows of one of several tests: adds those about this test to the head.
void take_lines_below(TableLayout& layout, std::vector<std::string> lines);

}  // namespace triax::lab

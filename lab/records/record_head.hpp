// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All that can be said of a record before its first reading, from its head, from the TOML file
// beside it, from the dialect and from --set, the later one stronger.
#include <optional>
#include <string>
#include <string_view>

#include "lab/records/findings.hpp"
#include "lab/records/table_layout.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Name, source, dialect and columns; then what the preamble says by the dialect's keys. Values
/// that cannot be read are left out with a finding.
void describe_record(RecordHeader& header, const TableLayout& layout, Findings& findings);

/// The preamble of our CSV as TOML text of as many lines as the head has; empty if there is none.
std::string toml_preamble(const TableLayout& layout);

/// The one stage of a record that has no stage column: the dialect's. If the dialect leaves the
/// drainage open, it is that of the type of test (find_test_type), else that of the columns (pore
/// pressure; volume change). It stays unknown without a type if the back volume was read, because
/// then its readings decide.
StageInfo single_stage(const TableLayout& layout, std::string_view programme);

}  // namespace triax::lab

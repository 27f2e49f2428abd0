// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the page changes: records that are taken in, tests that are run.
#include "src/page/api/laboratory.hpp"
#include "src/page/request/request.hpp"

namespace triax::src {

/// Reads the record that was sent, as RecordToRead describes. Query: name, set=KEY=VALUE
/// (repeatable), dialect=LINE (repeatable; lines of TOML), worksheet.
PageAnswer take_record(PageLaboratory& laboratory, const PageRequest& request, RecordTask task);
/// Writes the dialect of a user's choices: {"dialect": TOML, "file": where it was remembered, or
/// null}. Body: name, encoding, separator, decimal, thousands, worksheet, block, columns (quantity,
/// position, unit, sign, date_order), values (kPa by quantity), and key (of
/// study::proposal_json()): with it the dialect, without the values, is stored for tables with
/// these headings. Throws Refused for choices that are no dialect.
PageAnswer write_chosen_dialect(PageLaboratory& laboratory, const std::string& body);
/// Begins a test of a programme; its number.
PageAnswer begin_run(PageLaboratory& laboratory, const std::string& body);
PageAnswer order_run(PageLaboratory& laboratory, std::int64_t test, RunOrder::Kind kind,
                     const std::string& body);
/// An address that lets one more browser in.
PageAnswer another_browser(PageLaboratory& laboratory);
/// Samples with the fields of their forms.
PageAnswer list_of_programmes();

}  // namespace triax::src

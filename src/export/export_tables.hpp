// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tests as text for other programs.
#include <string>
#include <vector>

#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// The record in our own CSV (docs/reference/record-files.md): triax replay reads it again, bit for
/// bit. No cell of it is a formula to a spreadsheet (lab::toml_quoted).
void export_record(const db::Store& store, const db::StoredTest& test, const std::string& path);

/// The states and second-order work as CSV: numbers only.
void export_states(const db::Store& store, const db::StoredTest& test, const std::string& path);

/// The document of `triax report --format json`, and in each test "readings" and "states", each of
/// "columns" and "rows".
void export_json(const db::Store& store, const std::vector<study::TestResult>& tests,
                 const std::string& path);

}  // namespace triax::src

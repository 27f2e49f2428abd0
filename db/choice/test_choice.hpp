// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace triax::db {

/// A test that a condition in SQL holds for, with the value of a column as text ("" for NULL).
struct ChosenTest {
  std::int64_t id = 0;
  std::string group;
};

/// Tests for which `where` (empty: all) is true, oldest first; `group` is a column of the same
/// table, or an expression of such columns; empty: none. The columns are test_id, test, origin,
/// programme, status, source, tags (one text, blanks between), material, void_ratio, p0_eff_kPa,
/// kind, eta (at the onset), csr, sweep. Throws as query() does, with SQLite's own words for what
/// it does not understand.
std::vector<ChosenTest> choose_tests(const std::string& path, const std::string& where,
                                     const std::string& group);

}  // namespace triax::db

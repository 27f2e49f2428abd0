// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace triax::db {

using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

/// A question that users ask, kept with the schema: `triax query NAME`.
struct NamedQuery {
  std::string_view name;
  std::string_view purpose;  ///< one line for --list
  std::string_view sql;
};
const std::vector<NamedQuery>& named_queries();

/// Default time limit of a query.
inline constexpr double kQueryLimit_s = 60;

/// Runs a named query or one statement of SQL against the database, strictly read only: SQLite
/// itself refuses to write (read-only handle, query_only, and an authorizer that lets only reading
/// through). `columns` is called once, before the rows. Throws lab::BadInput for a database that
/// cannot be read and, with SQLite's own words, for SQL that cannot be run; lab::WorkFailed where
/// the disk fails, the file is damaged or stays locked, or where SQLite computes for longer than
/// `time_limit_s` (the time spent in `row` does not count). Rows given before a failure stand.
void query(const std::string& path, const std::string& name_or_sql,
           const std::function<void(const std::vector<std::string>&)>& columns,
           const std::function<void(const std::vector<Value>&)>& row,
           double time_limit_s = kQueryLimit_s);

}  // namespace triax::db

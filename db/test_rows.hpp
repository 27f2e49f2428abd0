// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What readers and writers of one test have in common: of its header and events, and of its
// summary.
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "db/columns.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/results/summary.hpp"

namespace triax::db {

/// Calls `use` with the columns of each row that the query gives for the test.
template <class Use>
void for_rows(SQLite::Database& database, std::int64_t id, const char* sql, const Use& use) {
  SQLite::Statement select(database, sql);
  select.bind(1, id);
  while (select.executeStep()) {
    Columns columns(select);
    use(columns);
  }
}

/// What a text of ours stands for. Throws lab::BadInput for one that this version does not know.
template <class Kind>
Kind known(const std::string& text, std::optional<Kind> (*kind_from)(std::string_view)) {
  if (const auto kind = kind_from(text)) return *kind;
  throw lab::BadInput(fmt::format(
      "the database contains '{}', which is unknown to this version of triax; use a newer version",
      text));
}

/// Of its two columns; nothing where the reading is NULL.
inline std::optional<lab::Moment> read_moment(Columns& c) {
  const auto reading = c.integer();
  const auto time_s = c.number();
  return reading ? std::optional(lab::Moment{*reading, time_s}) : std::nullopt;
}

inline void bind_moment(Binder& row, const std::optional<lab::Moment>& moment) {
  row.integer(moment ? std::optional(moment->reading) : std::nullopt)
      .number(moment ? moment->time_s : std::nullopt);
}

/// `found`: at_start or at_end.
inline void insert_warnings(SQLite::Database& database, std::int64_t id, std::string_view found,
                            const std::vector<lab::Warning>& warnings) {
  SQLite::Statement insert(database,
                           "INSERT INTO warnings (test_id, found, line, text) VALUES (?,?,?,?)");
  for (const lab::Warning& warning : warnings)
    Binder(insert)
        .integer(id)
        .text(found)
        .integer(warning.line > 0 ? std::optional(warning.line) : std::nullopt)
        .text(warning.text)
        .run();
}

}  // namespace triax::db

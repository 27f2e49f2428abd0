// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/revisions.hpp"

#include "db/test_rows.hpp"

namespace triax::db {

std::vector<Revision> read_revisions(SQLite::Database& database, std::int64_t test_id) {
  std::vector<Revision> all;
  for_rows(database, test_id,
           "SELECT revision, revised_at, former_kind, former_eta FROM revisions WHERE test_id = ? "
           "ORDER BY revision",
           [&](Columns& c) {
             Revision& revision = all.emplace_back();
             revision.number = c.integer().value_or(0);
             revision.revised_at = c.text();
             revision.former_kind = lab::collapse_kind_from(c.text());
             revision.former_eta = c.number();
           });
  for_rows(database, test_id,
           "SELECT revision, key, old_value, new_value FROM revised_values WHERE test_id = ? "
           "ORDER BY revision, position",
           [&](Columns& c) {
             const auto number = c.integer();
             RevisedValue value;
             value.key = c.text();
             value.before = c.text();
             value.after = c.text();
             for (Revision& revision : all)
               if (revision.number == number) revision.values.push_back(value);
           });
  return all;
}

void insert_revision(SQLite::Database& database, std::int64_t test_id, const Revision& revision) {
  SQLite::Statement insert(database, "INSERT INTO revisions VALUES (?,?,?,?,?)");
  Binder(insert)
      .integer(test_id)
      .integer(revision.number)
      .text(revision.revised_at)
      .text_or_null(revision.former_kind ? to_string(*revision.former_kind) : std::string_view())
      .number(revision.former_eta)
      .run();
  SQLite::Statement row(database, "INSERT INTO revised_values VALUES (?,?,?,?,?,?)");
  std::int64_t position = 0;
  for (const RevisedValue& value : revision.values)
    Binder(row)
        .integer(test_id)
        .integer(revision.number)
        .integer(++position)
        .text(value.key)
        .text_or_null(value.before)
        .text_or_null(value.after)
        .run();
}

}  // namespace triax::db

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Statements of sqlite_schema, compared by their words.
#include <string_view>

namespace triax::db {

/// Whether two statements that create the same thing say the same but for blanks, comments, quotes
/// around names, and columns of a table that are no more than a name and a type.
bool is_same_definition(std::string_view a, std::string_view b);

/// Whether the statement creates a table that SQLite itself stores, not a virtual one.
bool is_ordinary_table(std::string_view sql);

/// Whether the statement creates an index on columns as they are: not UNIQUE, not of expressions,
/// not of a part of the rows.
bool is_plain_index(std::string_view sql);

}  // namespace triax::db

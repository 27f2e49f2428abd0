// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The schema of a triax database, version by version: the migrations (db/migrations), and whether
// the schema of a file is one of them.
#include <SQLiteCpp/Database.h>

#include <string>

namespace triax::db {

/// The number of the newest migration (db/migrations/NNNN_name.sql).
int newest_schema();

/// Runs the migrations above `present` up to `target`. Inside the caller's transaction.
void apply_migrations(SQLite::Database& database, int present, int target);

/// Makes SQLite treat the schema of the file as data that a stranger wrote: no trigger runs, views
/// call no function with side effects, nothing writes to the schema directly, cells of pages are
/// checked. For every connection, before it reads anything.
void distrust_schema(SQLite::Database& database);

/// Throws lab::BadInput where the schema is not what triax made for the version of the file: a
/// trigger, an unknown view or virtual table, a table, view or index of triax that is missing or
/// differs. Column definitions of a name and a type may differ (db/channel_columns.hpp adds such).
/// Accepted are tables of the user with their indexes, and indexes of the user on columns of
/// triax's tables, but UNIQUE, partial and computed ones. The view `readings` is not compared: it
/// is re-created if it differs. `path` names the database in messages.
void check_schema(SQLite::Database& database, const std::string& path);

/// Throws lab::WorkFailed where the pages of the file are damaged (PRAGMA quick_check): 0.18 s for
/// a million readings (105 MB).
void check_pages(SQLite::Database& database, const std::string& path);

}  // namespace triax::db

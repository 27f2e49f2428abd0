// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The columns of scans, scan_details and the view `readings` that follow from the table of
// quantities (lab/results/quantity.cpp). A quantity that is new in that table gets its column when
// a database is next opened for writing; until then it reads as NULL.
#include <SQLiteCpp/Database.h>

#include <string>
#include <vector>

namespace triax::db {

/// Columns of `scans` and of `scan_details` in the order in which the program writes and reads
/// them, which need not be that of the file.
const std::vector<std::string>& scan_columns();
const std::vector<std::string>& detail_columns();

/// "a, b, c"; each behind `prefix`, as in "s.a, s.b, s.c".
std::string column_list(const std::vector<std::string>& columns, const std::string& prefix = "");
/// The same to select from `table`: NULL stands for a column that it lacks.
std::string selected(SQLite::Database& database, const std::string& table, const std::string& alias,
                     const std::vector<std::string>& columns);

/// Whether the tables have a column for every quantity, and the view `readings` is the one that
/// this program makes.
bool has_all_channels(SQLite::Database& database);
/// Adds the columns that are missing and re-creates the view if it differs. Inside the caller's
/// transaction.
void add_missing_channels(SQLite::Database& database);
/// For a database that is only read: a view of this connection that has all columns.
void show_all_channels(SQLite::Database& database);

}  // namespace triax::db

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Opening a triax database: what is accepted, how it is migrated, which settings a connection has.
#include <SQLiteCpp/Database.h>

#include <string>

namespace triax::db {

/// "TRIX", in the header of the file: `file` and this program tell a database of ours by it.
inline constexpr int kApplicationId = 0x54524958;

/// The number of the newest migration (db/migrations/NNNN_name.sql).
int newest_schema();

/// Applies the numbered migrations above the database's user_version up to `target`, all or none;
/// with the newest of them the columns of quantities that the database does not know yet.
/// Throws lab::BadInput if the file belongs to another program or to a newer triax.
void migrate(SQLite::Database& database, const std::string& path, int target = newest_schema());

/// Read-write, in WAL mode and of the newest schema; creates the file if it does not exist. Throws
/// lab::BadInput if that path cannot be a database, SQLite::Exception if the disk refuses.
SQLite::Database open_for_writing(const std::string& path);

/// Read only and query_only. Tests whose writer is gone are first marked as interrupted and an
/// older schema is migrated, where the file can be written. Throws lab::BadInput if the file is
/// missing, no triax database, of a newer schema, or of an older one that cannot be migrated.
SQLite::Database open_for_reading(const std::string& path);

/// Marks running tests and runs of grains whose writer is gone as interrupted.
void mark_abandoned_tests(SQLite::Database& database);

/// lab::BadInput or lab::WorkFailed for what SQLite says about `path`.
[[noreturn]] void throw_for(const SQLite::Exception& error, const std::string& path);

}  // namespace triax::db

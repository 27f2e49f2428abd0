// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reading a database as it truly is where SQLite cannot open it in its place, or where its schema
// is old, without changing a byte of it: a copy that only this process sees, gone when it is
// closed.
#include <SQLiteCpp/Database.h>

#include <string>

namespace triax::db {

/// Whether anything may wait beside `path` that is not yet in it: transactions in its -wal, a
/// -journal to be rolled back, a writer.
bool waits_beside(const std::string& path);

/// The state of `source` at one instant, also while others write it; of the newest schema. `path`
/// names it in messages. Throws lab::WorkFailed where there is no room in the folder of temporary
/// files (TMPDIR), SQLite::Exception.
SQLite::Database migrated_copy(SQLite::Database& source, const std::string& path);

/// The same from the files themselves, with what waits beside them, where SQLite cannot open them.
/// Throws lab::BadInput where one of them cannot be read or does not hold still, else as above.
SQLite::Database migrated_copy_of_files(const std::string& path);

}  // namespace triax::db

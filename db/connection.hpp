// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Opening a triax database: what is accepted, how it is migrated, which settings a connection has.
#include <SQLiteCpp/Database.h>

#include <chrono>
#include <string>

#include "db/schema/schema.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::db {

/// "TRIX", in the header of the file: `file` and this program tell a database of ours by it.
inline constexpr int kApplicationId = 0x54524958;

/// How long a statement waits for the lock of another program.
inline constexpr std::chrono::milliseconds kPatience{20000};

/// Applies the numbered migrations above the database's user_version up to `target`, all or none;
/// with the newest of them the columns of quantities that the database does not know yet.
/// Throws lab::BadInput if the file belongs to another program or to a newer triax.
void migrate(SQLite::Database& database, const std::string& path, int target = newest_schema());

/// Read-write, in WAL mode and of the newest schema; creates the file if it does not exist, and
/// looks for damage where it is small. A lock
/// that another program holds is waited for as long as `patience`. Throws lab::BadInput if that
/// path cannot be a database, lab::WorkFailed if the disk refuses.
SQLite::Database open_for_writing(const std::string& path,
                                  std::chrono::milliseconds patience = kPatience);

/// Read only and query_only: not a byte of the file changes. All that is there is read, also what a
/// killed program left in the -wal of a folder without write permission; an older schema reads as
/// the newest (both by a private copy, db/private_copy.hpp). Throws lab::BadInput if the file is
/// missing, empty, no triax database or of a newer schema, or cannot be read whole.
SQLite::Database open_for_reading(const std::string& path);

/// No file, or a database without tables, as it is while another process makes it or takes it away.
class NoDatabase : public lab::BadInput {
 public:
  using lab::BadInput::BadInput;
};

/// Throws lab::BadInput where no database can be made or be at `path`: a folder, a device, a pipe,
/// a socket, no name, no folder to put it in. Touches nothing.
void check_place(const std::string& path);

/// Throws lab::BadInput where open_for_reading() would because of what the file is; changes
/// nothing.
void check_there(const std::string& path);
/// The same of a database that is open.
void check_filled(SQLite::Database& database, const std::string& path);

/// What may pass by itself: a lock of another program, a disk that is full, one that does not
/// answer.
class MayPass : public lab::WorkFailed {
 public:
  using lab::WorkFailed::WorkFailed;
};

/// A database whose files were renamed, removed or replaced while it was written.
class FilesMoved : public MayPass {
 public:
  using MayPass::MayPass;
};

/// At the path of a database that was renamed, removed or replaced is none that can be written.
class NotInPlace : public MayPass {
 public:
  using MayPass::MayPass;
};

/// lab::BadInput, MayPass or lab::WorkFailed for what SQLite says about `path`.
[[noreturn]] void throw_for(const SQLite::Exception& error, const std::string& path);

}  // namespace triax::db

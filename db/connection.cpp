// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection.hpp"

#include <SQLiteCpp/Transaction.h>
#include <fcntl.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <QUrl>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>
#include <tuple>
#include <utility>

#include "db/channel_columns.hpp"
#include "db/files/folder_claim.hpp"
#include "db/private_copy.hpp"
#include "db/schema/schema.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/whole_file.hpp"

namespace triax::db {
namespace {

namespace fs = std::filesystem;

int read_int(SQLite::Database& database, const std::string& sql) {
  return database.execAndGet(sql).getInt();
}

bool is_empty(SQLite::Database& database) {
  return read_int(database, "SELECT count(*) FROM sqlite_schema") == 0;
}

/// Refuses what is not ours before anything is written.
void check_ours(SQLite::Database& database, const std::string& path) {
  // In this order: another program may make the file ours between the two.
  const bool empty = is_empty(database);
  const int id = read_int(database, "PRAGMA application_id");
  if (id != kApplicationId && (id != 0 || !empty))
    throw lab::BadInput(path, 0,
                        "this SQLite database belongs to another program; give a triax database or "
                        "a file that does not exist yet");
  const int version = read_int(database, "PRAGMA user_version");
  if (version > newest_schema())
    throw lab::BadInput(path, 0,
                        "schema version " + std::to_string(version) +
                            " is newer than this program's " + std::to_string(newest_schema()) +
                            "; use a newer triax");
  check_schema(database, path);
}

/// `target` is a path, or a URI where the flags say so.
SQLite::Database opened(const std::string& target, int flags, std::chrono::milliseconds patience) {
  SQLite::Database database(target, flags, static_cast<int>(patience.count()));
  distrust_schema(database);
  return database;
}

/// Two programs may create the file at once, and the switch to WAL does not wait by itself.
void switch_to_wal(SQLite::Database& database, std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  for (;;) {
    if (sqlite3_exec(database.getHandle(), "PRAGMA journal_mode = WAL", nullptr, nullptr,
                     nullptr) == SQLITE_OK)
      return;
    if (database.getErrorCode() != SQLITE_BUSY || std::chrono::steady_clock::now() > deadline)
      throw SQLite::Exception(database.getHandle());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/// Once a process: what is written later is written by programs that have looked. The time of birth
/// tells a file from a removed one that had its inode.
bool is_first_look(const std::string& path) {
  using Identity = std::tuple<unsigned, unsigned, std::uint64_t, std::int64_t, std::uint32_t>;
  static std::mutex mutex;
  static std::set<Identity> seen;
  struct statx file {};
  if (statx(AT_FDCWD, path.c_str(), 0, STATX_INO | STATX_BTIME, &file) != 0) return false;
  const std::lock_guard lock(mutex);
  return seen
      .emplace(file.stx_dev_major, file.stx_dev_minor, file.stx_ino, file.stx_btime.tv_sec,
               file.stx_btime.tv_nsec)
      .second;
}

void check_pages_of_small(SQLite::Database& database, const std::string& path) {
  // 15 ms; larger files are for repair() to check.
  constexpr std::uintmax_t kMaxChecked_bytes = 8U << 20U;
  std::error_code none;
  if (fs::file_size(path, none) <= kMaxChecked_bytes && is_first_look(path))
    check_pages(database, path);
}

void prepare_for_writing(SQLite::Database& database, const std::string& path,
                         std::chrono::milliseconds patience) {
  check_ours(database, path);
  check_pages_of_small(database, path);
  // Large pages: the scans of a test are read and written in long runs.
  if (is_empty(database)) database.exec("PRAGMA page_size = 32768");
  switch_to_wal(database, patience);
  // NORMAL syncs at checkpoints only: a killed program loses nothing that was committed.
  database.exec(
      "PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 500; PRAGMA foreign_keys = ON; "
      "PRAGMA cache_size = -8192");
  migrate(database, path);
}

void check_exists(const std::string& path) {
  check_place(path);
  if (!fs::exists(path))
    throw NoDatabase(path, 0,
                     "database does not exist; `triax replay`, `simulate` and `grains` create one");
}

SQLite::Database read_only(SQLite::Database database) {
  database.exec("PRAGMA query_only = ON");
  return database;
}

SQLite::Database of_newest_schema(SQLite::Database database, const std::string& path) {
  check_filled(database, path);
  if (read_int(database, "PRAGMA user_version") < newest_schema())
    return read_only(migrated_copy(database, path));
  if (!has_all_channels(database)) show_all_channels(database);
  return read_only(std::move(database));
}

SQLite::Database opened_in_place(const std::string& path) {
  return of_newest_schema(opened(path, SQLite::OPEN_READONLY | SQLite::OPEN_NOMUTEX, kPatience),
                          path);
}

/// A database in a folder without write permission: WAL needs files beside it, unless nobody
/// writes.
SQLite::Database immutable(const std::string& path) {
  const QByteArray escaped = QUrl::toPercentEncoding(
      QString::fromStdString(fs::absolute(path).string()), QByteArrayLiteral("/"));
  return opened("file:" + escaped.toStdString() + "?immutable=1",
                SQLite::OPEN_READONLY | SQLite::OPEN_URI, {});
}

/// Whether a file of the database can hardly grow any more by such a limit on the size of files.
bool is_at_size_limit(const std::string& path, rlim_t limit) {
  constexpr std::uintmax_t kNear = 1U << 16U;  // of the index beside a -wal, and a few pages
  if (limit == RLIM_INFINITY) return false;
  for (const char* beside : {"", "-wal", "-shm"}) {
    std::error_code none;
    const auto size = fs::file_size(path + beside, none);
    if ((none ? 0 : size) + kNear > limit) return true;
  }
  return false;
}

/// No disk that is freed lifts a hard limit; a soft one somebody may.
[[noreturn]] void throw_for_room(const std::string& path, const std::string& words) {
  rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
  getrlimit(RLIMIT_FSIZE, &limit);
  if (!is_at_size_limit(path, limit.rlim_cur)) throw MayPass(words);
  const std::string limited = words + "; the size of a file is limited here to " +
                              std::to_string(limit.rlim_cur / 1024) + " kB (ulimit -f)";
  if (is_at_size_limit(path, limit.rlim_max)) throw lab::WorkFailed(limited);
  throw MayPass(limited);
}

}  // namespace

void check_place(const std::string& path) {
  if (path.empty() || path == ":memory:")  // SQLite has databases of these names, on no disk
    throw lab::BadInput("the database must be a file, such as triax.db; " + lab::excerpt(path) +
                        " is not a file name");
  std::error_code unknown;
  const fs::file_type type = fs::status(path, unknown).type();
  if (type == fs::file_type::directory)
    throw lab::BadInput(path, 0,
                        "is a folder; expected a file, such as " + path +
                            (path.ends_with('/') ? "" : "/") + "triax.db");
  if (fs::exists(fs::file_status(type)) && type != fs::file_type::regular &&
      type != fs::file_type::unknown)
    throw lab::BadInput(path, 0, "is a device, a pipe or a socket; expected a regular file");
  lab::check_folder_of(path);
}

void migrate(SQLite::Database& database, const std::string& path, int target) {
  const bool newest = target >= newest_schema();
  if (!is_empty(database) && read_int(database, "PRAGMA user_version") >= target &&
      (!newest || has_all_channels(database)))
    return;
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  check_ours(database, path);
  const int present = read_int(database, "PRAGMA user_version");
  apply_migrations(database, present, target);
  if (present < target) {
    database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
    database.exec("PRAGMA user_version = " + std::to_string(target));
  }
  if (newest) add_missing_channels(database);
  transaction.commit();
}

SQLite::Database open_for_writing(const std::string& path, std::chrono::milliseconds patience) {
  check_place(path);
  const FolderClaim claim(path, FolderClaim::Kind::shared);
  try {
    // No mutexes: a connection belongs to one thread at a time.
    SQLite::Database database =
        opened(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_NOMUTEX, patience);
    try {
      prepare_for_writing(database, path, patience);
    } catch (const SQLite::Exception& error) {
      throw_for(error, path);  // while the files beside it are there: they tell what was in the way
    }
    return database;
  } catch (const SQLite::Exception& error) {
    throw_for(error, path);
  }
}

void check_filled(SQLite::Database& database, const std::string& path) {
  check_ours(database, path);
  if (is_empty(database))
    throw NoDatabase(
        path, 0, "database is empty; `triax replay`, `simulate` and `grains` store tests in it");
}

SQLite::Database open_for_reading(const std::string& path) {
  check_exists(path);
  try {
    try {
      return opened_in_place(path);
    } catch (const SQLite::Exception& error) {
      // The files that SQLite needs beside it are not there and cannot be made.
      const int code = error.getErrorCode();
      if (code != SQLITE_CANTOPEN && code != SQLITE_READONLY) throw;
    }
    return waits_beside(path) ? read_only(migrated_copy_of_files(path))
                              : of_newest_schema(immutable(path), path);
  } catch (const SQLite::Exception& error) {
    throw_for(error, path);
  }
}

void check_there(const std::string& path) {
  check_exists(path);
  try {
    SQLite::Database database =
        opened(path, SQLite::OPEN_READONLY | SQLite::OPEN_NOMUTEX, kPatience);
    check_filled(database, path);
  } catch (const SQLite::Exception& error) {
    throw_for(error, path);
  }
}

void throw_for(const SQLite::Exception& error, const std::string& path) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      throw lab::BadInput(
          path, 0,
          "is not an SQLite database; give a triax database or a file that does not exist yet");
    case SQLITE_CANTOPEN:
      throw lab::BadInput(path, 0, "cannot be opened; check the permissions of file and folder");
    case SQLITE_READONLY:
    case SQLITE_PERM:
      throw lab::BadInput(path, 0, "cannot be written; check the permissions of file and folder");
    case SQLITE_FULL:
    case SQLITE_IOERR:
      throw_for_room(path, path + ": " + error.what());
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_PROTOCOL:
      throw MayPass(path + ": " + error.what());
    default:
      throw lab::WorkFailed(path + ": " + error.what());
  }
}

}  // namespace triax::db

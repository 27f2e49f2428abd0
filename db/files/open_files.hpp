// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <SQLiteCpp/Database.h>
#include <sys/types.h>

#include <array>
#include <string>

namespace triax::db {

/// The files of an open database: whether they are still where they were when it was opened. A file
/// that was renamed or removed keeps what is written to it, but is lost to readers; without
/// its -wal or -shm a database is not whole for others.
class OpenFiles {
 public:
  /// Of a database in WAL mode that has been read from. `path` as it was opened.
  OpenFiles(SQLite::Database& database, std::string path);
  ~OpenFiles();
  OpenFiles(const OpenFiles&) = delete;
  OpenFiles& operator=(const OpenFiles&) = delete;

  /// The file that is gone or another one now; empty while all are in place. Sees a file that was
  /// renamed, removed or replaced (SQLITE_FCNTL_HAS_MOVED), also with its folder or behind a
  /// symbolic link; not one that was overwritten in its place.
  std::string missing() const;

  /// Of files that are not in place: brings what waits in the -wal into the file of the database
  /// and removes that -wal, which would spoil another database put under the old name. Does nothing
  /// where somebody else uses the file. The connection reads and writes as before.
  void make_whole() const;

  /// The path of the database today: as it was opened, or in the new place of its folder where that
  /// was renamed. A folder that was removed is made again under its old name.
  std::string path_today() const;

 private:
  /// Device and inode; zeros where there is no file.
  struct Identity {
    dev_t device = 0;
    ino_t inode = 0;
    bool operator==(const Identity&) const = default;
  };
  static Identity identity_of(const std::string& path);

  SQLite::Database& database_;
  std::array<std::string, 3> paths_;
  std::array<Identity, 3> identities_;
  int folder_;  ///< a descriptor
};

}  // namespace triax::db

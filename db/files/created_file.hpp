// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <string>

namespace triax::db {

/// A database file that this process has just made, for which it may turn out that there is nothing
/// to keep.
class CreatedFile {
 public:
  CreatedFile(std::string path, SQLite::Database& database);

  /// Removes the file and closes the connection, if nobody else has committed anything since, none
  /// has it open and none is opening it (FolderClaim); otherwise leaves both. Pre-condition: what
  /// this process stored is taken out again.
  void remove_if_unused(std::optional<SQLite::Database>& database) const;

 private:
  std::string path_;
  std::int64_t version_;  ///< changes when another connection commits
};

}  // namespace triax::db

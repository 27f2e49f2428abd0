// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/files/created_file.hpp"

#include <filesystem>
#include <utility>

#include "db/files/folder_claim.hpp"

namespace triax::db {
namespace {

std::int64_t version_for_this_connection(SQLite::Database& database) {
  return database.execAndGet("PRAGMA data_version").getInt64();
}

bool holds_anything(SQLite::Database& database) {
  return database
             .execAndGet(
                 "SELECT EXISTS (SELECT 1 FROM tests) OR EXISTS (SELECT 1 FROM grain_runs) "
                 "OR EXISTS (SELECT 1 FROM reference_results)")
             .getInt() != 0;
}

}  // namespace

CreatedFile::CreatedFile(std::string path, SQLite::Database& database)
    : path_(std::move(path)), version_(version_for_this_connection(database)) {}

void CreatedFile::remove_if_unused(std::optional<SQLite::Database>& database) const {
  const FolderClaim claim(path_, FolderClaim::Kind::exclusive);
  if (!claim.held() || version_for_this_connection(*database) != version_) return;
  if (holds_anything(*database)) return;
  // Leaving WAL succeeds only for the last connection: nobody else uses the file.
  if (database->tryExec("PRAGMA busy_timeout = 0; PRAGMA journal_mode = DELETE") != 0) return;
  database.reset();
  std::filesystem::remove(path_);
}

}  // namespace triax::db

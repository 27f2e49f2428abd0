// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/files/open_files.hpp"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <utility>

namespace triax::db {
namespace {

namespace fs = std::filesystem;
enum File : std::size_t { kMain, kWal, kShm };

std::string folder_of(const std::string& file) {
  const std::string folder = fs::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

OpenFiles::Identity OpenFiles::identity_of(const std::string& path) {
  struct stat found {};
  return stat(path.c_str(), &found) == 0 ? Identity{found.st_dev, found.st_ino} : Identity{};
}

OpenFiles::OpenFiles(SQLite::Database& database, std::string path)
    : database_(database),
      folder_(::open(folder_of(path).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
  const std::string resolved = sqlite3_db_filename(database.getHandle(), "main");
  paths_ = {std::move(path), resolved + "-wal", resolved + "-shm"};
  for (std::size_t i = 0; i < paths_.size(); ++i) identities_[i] = identity_of(paths_[i]);
}

OpenFiles::~OpenFiles() {
  if (folder_ >= 0) ::close(folder_);
}

std::string OpenFiles::missing() const {
  int has_moved = 0;
  sqlite3_file_control(database_.getHandle(), "main", SQLITE_FCNTL_HAS_MOVED, &has_moved);
  if (has_moved != 0) return paths_[kMain];
  for (std::size_t i = 0; i < paths_.size(); ++i)
    if (identity_of(paths_[i]) != identities_[i]) return paths_[i];
  return {};
}

void OpenFiles::make_whole() const {
  const Identity wal = identity_of(paths_[kWal]);
  if (wal != Identity{} && wal != identities_[kWal]) return;  // SQLite would remove that
  // Only the last connection can leave WAL mode: no other process uses the file, under any name.
  database_.tryExec("PRAGMA busy_timeout = 0; PRAGMA journal_mode = DELETE");
}

std::string OpenFiles::path_today() const {
  const std::string& path = paths_[kMain];
  std::error_code none;
  if (folder_ < 0 || fs::is_directory(folder_of(path), none)) return path;
  const auto now = fs::read_symlink("/proc/self/fd/" + std::to_string(folder_), none);
  if (!none && fs::is_directory(now, none)) return (now / fs::path(path).filename()).string();
  fs::create_directories(folder_of(path), none);
  return path;
}

}  // namespace triax::db

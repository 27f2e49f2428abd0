// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/private_copy.hpp"

#include <SQLiteCpp/Backup.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "db/connection.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"

namespace triax::db {
namespace {

namespace fs = std::filesystem;

/// What SQLite keeps beside a database that belongs to its content.
constexpr std::array<const char*, 2> kBeside = {"-wal", "-journal"};

constexpr const char* kElsewhere = "; set TMPDIR to another folder for temporary files";

class PrivateFolder {
 public:
  /// `path` is of the database that is to be copied.
  explicit PrivateFolder(const std::string& path) {
    const char* const named = std::getenv("TMPDIR");
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error)
      throw lab::WorkFailed(
          path + ": is read through a temporary copy, and no temporary folder is available: " +
          (named != nullptr ? "TMPDIR is " + std::string(named) : "/tmp") + ": " + error.message() +
          kElsewhere);
    std::string pattern = (folder / "triax-reading-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw lab::WorkFailed(path + ": is read through a temporary copy, and " + pattern +
                            " cannot be created: " + std::strerror(errno) + kElsewhere);
    path_ = pattern;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  std::string database() const { return path_ / "copy.db"; }

 private:
  fs::path path_;
};

/// What changes whenever the file itself is written. A writer that only appends to the -wal
/// meanwhile does no harm: a copy of it ends with the last whole transaction.
struct Unchanged {
  explicit Unchanged(const std::string& path) {
    struct stat of {};
    if (stat(path.c_str(), &of) == 0) file = {of.st_size, of.st_mtim.tv_sec, of.st_mtim.tv_nsec};
    std::ifstream(path + "-wal", std::ios::binary).read(wal_header.data(), std::ssize(wal_header));
  }
  bool operator==(const Unchanged&) const = default;
  std::array<std::int64_t, 3> file{};
  std::array<char, 32> wal_header{};
};

[[noreturn]] void no_room(const std::string& path, const std::string& copy,
                          const std::string& why) {
  throw lab::WorkFailed(path + ": is read through a temporary copy, and " + copy +
                        " cannot be written: " + why + kElsewhere);
}

/// The copy may be written where the database may not.
void copy(const std::string& from, const std::string& to, const std::string& path) {
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (!error) return fs::permissions(to, fs::perms::owner_read | fs::perms::owner_write);
  // The library tells a full disk as an error of input or output.
  if (access(from.c_str(), R_OK) == 0) no_room(path, to, error.message());
  throw lab::BadInput(path, 0,
                      "cannot be read completely: " + from + ": " + error.message() +
                          "; this file contains some of the tests: make it readable, or run `triax "
                          "tests repair` as a user with write permission");
}

void copy_files(const std::string& file, const std::string& to, const std::string& path) {
  copy(file, to, path);
  for (const char* ending : kBeside) {
    fs::remove(to + ending);
    if (fs::exists(file + ending)) copy(file + ending, to + ending, path);
  }
}

/// The folder and its file lose their names: they are gone when the connection is.
SQLite::Database opened_and_migrated(const PrivateFolder& folder, const std::string& path) try {
  SQLite::Database copy(folder.database(), SQLite::OPEN_READWRITE | SQLite::OPEN_NOMUTEX);
  distrust_schema(copy);
  copy.exec("PRAGMA journal_mode = MEMORY; PRAGMA temp_store = MEMORY; PRAGMA synchronous = OFF");
  check_filled(copy, path);
  migrate(copy, path);
  return copy;
} catch (const SQLite::Exception& error) {
  if (error.getErrorCode() != SQLITE_FULL && error.getErrorCode() != SQLITE_IOERR) throw;
  no_room(path, folder.database(), error.what());
}

}  // namespace

bool waits_beside(const std::string& path) {
  const std::string file = lab::behind_links(path);
  for (const char* ending : kBeside) {
    std::error_code error;
    const auto size = fs::file_size(file + ending, error);
    if (error ? error != std::errc::no_such_file_or_directory : size > 0) return true;
  }
  return fs::exists(file + "-shm");  // somebody may have opened it
}

SQLite::Database migrated_copy(SQLite::Database& source, const std::string& path) {
  const PrivateFolder folder(path);
  try {
    SQLite::Database copy(folder.database(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    SQLite::Backup(copy, source).executeStep();
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode();
    if (code != SQLITE_FULL && (code != SQLITE_IOERR || source.getErrorCode() == code)) throw;
    throw lab::WorkFailed(
        path +
        ": is from an older version of triax and is read through a temporary copy, for which " +
        folder.database() +
        " has no free space; set TMPDIR to another folder for temporary files, or update the "
        "database with `triax tests repair`");
  }
  return opened_and_migrated(folder, path);
}

SQLite::Database migrated_copy_of_files(const std::string& path) {
  const PrivateFolder folder(path);
  const std::string file = lab::behind_links(path);  // beside it SQLite keeps its others
  constexpr int kTries = 5;
  for (int i = 0; i < kTries; ++i) {
    const Unchanged before(file);
    copy_files(file, folder.database(), path);
    if (Unchanged(file) == before) return opened_and_migrated(folder, path);
  }
  throw lab::BadInput(path, 0,
                      "is being written by a program whose files next to it cannot be opened; get "
                      "read permission for " +
                          path + "-shm, or wait until it has ended");
}

}  // namespace triax::db

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::db {

/// A claim on the folder of a database (flock), for as long as it lives: whoever opens the file for
/// writing holds a shared one until its connection holds SQLite's own lock, whoever removes the
/// file an exclusive one. So no file is removed between another program's opening it and its lock.
/// It ends with the process at the latest.
class FolderClaim {
 public:
  enum class Kind { shared, exclusive };

  /// Shared: waits while a file is being removed. Exclusive: does not wait.
  FolderClaim(const std::string& file, Kind kind);
  ~FolderClaim();
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;

  /// False where another has a claim, or where the file system knows none.
  bool held() const { return held_; }

 private:
  int folder_ = -1;
  bool held_ = false;
};

}  // namespace triax::db

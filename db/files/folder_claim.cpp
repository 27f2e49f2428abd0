// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/files/folder_claim.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace triax::db {

FolderClaim::FolderClaim(const std::string& file, Kind kind) {
  const auto folder = std::filesystem::path(file).parent_path();
  folder_ = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) return;
  const int operation = kind == Kind::shared ? LOCK_SH : LOCK_EX | LOCK_NB;
  int outcome = 0;
  do outcome = ::flock(folder_, operation);
  while (outcome != 0 && errno == EINTR);
  held_ = outcome == 0;
}

FolderClaim::~FolderClaim() {
  if (folder_ >= 0) ::close(folder_);
}

}  // namespace triax::db

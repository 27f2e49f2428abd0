// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {

namespace fs = std::filesystem;

std::string handle_of(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

mode_t permissions_for_new_files() {
  const auto mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

std::string behind_links(const std::string& path) {
  constexpr int kMostLinks = 40;
  fs::path at = path;
  std::error_code none;
  for (int i = 0; i < kMostLinks && fs::is_symlink(at, none); ++i) {
    const auto next = fs::read_symlink(at, none);
    if (none) break;
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at.string();
}

void check_folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  if (std::error_code none; !folder.empty() && !fs::is_directory(folder, none))
    throw BadInput(path, 0, "folder " + folder.string() + " does not exist; create it first");
}

std::string describe_write_error(const std::string& path, int error) {
  return path + ": cannot be written: " + std::strerror(error);
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

WholeFile::WholeFile(const std::string& path) : path_(path), target_(behind_links(path)) {
  struct stat present {};
  const bool exists = ::stat(target_.c_str(), &present) == 0;
  if (!exists && errno != ENOENT) fail();
  if (exists && S_ISDIR(present.st_mode)) throw BadInput(path_, 0, "is a folder; expected a file");
  if (exists && !S_ISREG(present.st_mode))
    throw BadInput(path_, 0, "is a device or a pipe; expected a regular file");
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail();
  if (!exists) check_folder_of(target_);
  if (!open_nameless()) open_named();
  ::fchmod(descriptor_, exists ? present.st_mode & 0777 : permissions_for_new_files());
}

WholeFile::~WholeFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!part_.empty()) ::unlink(part_.c_str());
}

void WholeFile::fail() const {
  const int error = errno;
  const std::string what = describe_write_error(path_, error);
  if (error == ENOSPC || error == EDQUOT) throw NoRoom(what);
  throw WorkFailed(what);
}

bool WholeFile::open_nameless() {
  const auto folder = fs::path(target_).parent_path();
  descriptor_ = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC,
                       S_IRUSR | S_IWUSR);
  if (descriptor_ < 0) return false;
  // Without /proc it could not be given a name later.
  if (::access(handle_of(descriptor_).c_str(), F_OK) == 0) return true;
  ::close(std::exchange(descriptor_, -1));
  return false;
}

void WholeFile::open_named() {
  part_ = target_ + ".part-XXXXXX";
  descriptor_ = ::mkostemp(part_.data(), O_CLOEXEC);
  if (descriptor_ >= 0) return;
  part_.clear();
  fail();
}

void WholeFile::name_the_nameless() {
  const auto handle = handle_of(descriptor_);
  if (::linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, target_.c_str(), AT_SYMLINK_FOLLOW) == 0) return;
  // A link cannot replace a file; a name for an instant and a rename can.
  for (unsigned attempt = 0;; ++attempt) {
    const auto name =
        target_ + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    if (::linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      part_ = name;
      return;
    }
    if (errno != EEXIST) fail();
  }
}

void WholeFile::write(std::string_view bytes) {
  if (!write_all(descriptor_, bytes)) fail();
}

void WholeFile::finish() {
  if (::fsync(descriptor_) != 0) fail();
  if (part_.empty()) name_the_nameless();
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
  if (!part_.empty() && std::rename(part_.c_str(), target_.c_str()) != 0) fail();
  part_.clear();
}

}  // namespace triax::lab

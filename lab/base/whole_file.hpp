// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "lab/base/bad_input.hpp"

namespace triax::lab {

/// The disk is full: it may be freed, and the same file be written then.
class NoRoom : public WorkFailed {
 public:
  using WorkFailed::WorkFailed;
};

/// A file that appears under its name whole or not at all.
///
/// What is written stands in the folder of the target without any name, so that not even a killed
/// program leaves it behind; where the file system knows no such files it is PATH.part-XXXXXX,
/// which the destructor removes. A symbolic link is followed: the file that it points at is
/// replaced, the link stays. A file that is replaced passes its permissions on.
class WholeFile {
 public:
  /// Throws BadInput if `path` exists and is no regular file (folder, device, pipe, socket), or if
  /// its folder does not exist; WorkFailed if the folder is not writable.
  explicit WholeFile(const std::string& path);
  /// Without finish(): nothing remains.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Throws NoRoom or WorkFailed.
  void write(std::string_view bytes);
  /// Brings all to the disk and gives the file its name, replacing an older one. Throws
  /// WorkFailed; then nothing stands under that name that was not there before.
  void finish();

 private:
  [[noreturn]] void fail() const;
  bool open_nameless();
  void open_named();
  void name_the_nameless();

  std::string path_;    // as the user gave it
  std::string target_;  // behind all symbolic links
  std::string part_;    // empty while the file has no name
  int descriptor_ = -1;
};

/// The path with a symbolic link at its end followed, also to a file that does not exist yet.
std::string behind_links(const std::string& path);

/// Throws BadInput "PATH: folder F does not exist; create it first" if the folder of the path does
/// not exist.
void check_folder_of(const std::string& path);

/// "PATH: cannot be written: " and the system's reason for `error` (errno).
std::string describe_write_error(const std::string& path, int error);

/// Writes all bytes to an open descriptor; false, with errno, where that fails.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace triax::lab

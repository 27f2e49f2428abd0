// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a command wrote, to be announced when it ends: one way for reports, figures and data.
#include <string>
#include <vector>

namespace triax::src {

/// One file, noted before it is written: whether something is replaced cannot be seen afterwards.
/// The same file written twice in a command is one. Pipes, devices, "-" and an empty path are none.
class WrittenFile {
 public:
  explicit WrittenFile(std::string path);
  void is_there() const;  ///< written whole: to be announced

 private:
  std::string path_;
  bool file_ = false, replaces_ = false;
};

/// "wrote a.csv and a.json, replaced b.svg", and forgets them; empty where nothing was written.
/// Beyond a dozen files their number and the first stand for them.
[[nodiscard]] std::string take_announcement();

}  // namespace triax::src

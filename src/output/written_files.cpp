// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/written_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <utility>

namespace triax::src {
namespace {

struct Written {
  std::vector<std::string> made, replaced;
};

/// Of the command that runs; a process runs one.
Written& written() {
  static Written files;
  return files;
}

bool holds(const std::vector<std::string>& files, const std::string& path) {
  return std::ranges::find(files, path) != files.end();
}

std::string list(const char* what, const std::vector<std::string>& files) {
  constexpr std::size_t kMostNames = 12;
  if (files.empty()) return {};
  if (files.size() > kMostNames)
    return fmt::format("{} {} files: {} to {}", what, files.size(), files.front(), files.back());
  std::string text = fmt::format("{} ", what);
  for (std::size_t i = 0; i < files.size(); ++i)
    text += (i == 0 ? "" : i + 1 == files.size() ? " and " : ", ") + files[i];
  return text;
}

}  // namespace

WrittenFile::WrittenFile(std::string path) : path_(std::move(path)) {
  struct stat present {};
  replaces_ = ::stat(path_.c_str(), &present) == 0;
  file_ = !path_.empty() && path_ != "-" && (!replaces_ || S_ISREG(present.st_mode));
}

void WrittenFile::is_there() const {
  if (!file_ || holds(written().made, path_) || holds(written().replaced, path_)) return;
  (replaces_ ? written().replaced : written().made).push_back(path_);
}

std::string take_announcement() {
  const Written files = std::exchange(written(), {});
  const std::string made = list("wrote", files.made), replaced = list("replaced", files.replaced);
  return made + (made.empty() || replaced.empty() ? "" : ", ") + replaced;
}

}  // namespace triax::src

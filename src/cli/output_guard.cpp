// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/output_guard.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"

namespace triax::src {
namespace {

namespace fs = std::filesystem;

bool same_file(const std::string& a, const std::string& b) {
  std::error_code missing;
  if (fs::equivalent(a, b, missing) && !missing) return true;
  const auto place = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(lab::behind_links(path)), missing);
  };
  return place(a) == place(b);
}

}  // namespace

std::vector<std::string> database_files(const std::string& db) {
  std::vector<std::string> files;
  for (const auto& name : {db, lab::behind_links(db)})
    for (const char* ending : {"", "-wal", "-shm", "-journal"}) files.push_back(name + ending);
  return files;
}

void refuse_overwriting(const std::string& option, const std::string& output,
                        const std::vector<std::string>& kept, const std::string& what) {
  if (output.empty() || output == "-") return;
  for (const auto& file : kept)
    if (same_file(output, file))
      throw lab::BadInput(
          fmt::format("{} {}: this file is {} ({}) and would be overwritten; give another name",
                      option, output, what, file));
}

std::vector<std::string> files_of_prefix(const std::string& prefix,
                                         const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const auto& name : names)
    for (const char* ending : {".csv", ".json", ".svg", ".png", ".pdf"})
      files.push_back(prefix + name + ending);
  return files;
}

namespace {

void check_writable(const fs::path& folder, const std::string& target) {
  if (::access((folder / "").c_str(), W_OK | X_OK) != 0)
    throw lab::WorkFailed(lab::describe_write_error(target, errno));
}

void check_file(const std::string& option, const std::string& output, const std::string& target) {
  std::error_code none;
  const fs::path file = lab::behind_links(target);
  const auto kind = fs::status(file, none).type();
  if (kind == fs::file_type::directory)
    throw lab::BadInput(
        fmt::format("{} {}: {} is a folder; expected a file", option, output, target));
  if (kind == fs::file_type::character || kind == fs::file_type::fifo) return;
  lab::check_folder_of(file.string());
  check_writable(file.has_parent_path() ? file.parent_path() : ".", target);
}

}  // namespace

std::string prefix_in(const std::string& folder, const std::string& command) {
  return folder.empty() ? "" : (fs::path(folder) / command).string();
}

void make_folder(const std::string& option, const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (std::error_code none; !fs::is_directory(folder, none))
    throw lab::BadInput(fmt::format("{} {}: folder cannot be created{}", option, folder,
                                    failed ? ": " + failed.message() : std::string()));
}

void check_folder(const std::string& option, const std::string& folder,
                  const std::vector<std::string>& targets) {
  if (folder.empty()) return;
  std::error_code none;
  if (fs::exists(folder, none)) {
    if (!fs::is_directory(folder, none))
      throw lab::BadInput(fmt::format("{} {}: is a file; expected a folder", option, folder));
    for (const auto& target : targets) check_file(option, folder, target);
    return;
  }
  // The nearest that there is has to let folders be made in it.
  fs::path above = fs::absolute(folder, none).lexically_normal();
  while (!fs::exists(above, none) && above.has_relative_path()) above = above.parent_path();
  if (!fs::is_directory(above, none))
    throw lab::BadInput(
        fmt::format("{} {}: {} is a file; expected a folder", option, folder, above.string()));
  check_writable(above, folder);
}

void check_targets(const std::string& option, const std::string& output,
                   const std::vector<std::string>& targets) {
  if (output.empty() || output == "-") return;
  if (output.back() == '/')
    throw lab::BadInput(fmt::format("{} {}: is a folder; expected a file", option, output));
  for (const auto& target : targets) check_file(option, output, target);
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs the built program as a user would, in a folder of its own.
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace triax::cli_tests {

inline std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

struct Outcome {
  int status = -1;
  std::string out, err;
};

/// A folder that goes with the test.
class Workplace {
 public:
  Workplace() {
    std::string pattern = (std::filesystem::temp_directory_path() / "triax_cli_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Workplace() { std::filesystem::remove_all(folder_); }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  bool has(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  /// triax ARGUMENTS (as a shell splits them) in this folder, with this text as its input.
  Outcome triax(const std::string& arguments, const std::string& input = {}) const {
    if (!input.empty()) write(folder_ / ".in", input);
    const std::string command = "cd '" + folder_.string() +
                                "' && unset COLUMNS; " TRIAX_PROGRAM " " + arguments +
                                " >.out 2>.err <" + (input.empty() ? "/dev/null" : ".in");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder_ / ".out"),
            content(folder_ / ".err")};
  }

 private:
  std::filesystem::path folder_;
};

/// A file of the source tree, by its absolute path.
inline std::string source(const std::string& name) {
  return std::filesystem::absolute(name).string();
}

}  // namespace triax::cli_tests

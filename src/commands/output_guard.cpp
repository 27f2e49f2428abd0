#include "src/commands/output_guard.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "lab/records/bad_input.hpp"
#include "lab/records/whole_file.hpp"

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
          fmt::format("{} {}: this is {} ({}) and would be overwritten; name another file", option,
                      output, what, file));
}

}  // namespace triax::src

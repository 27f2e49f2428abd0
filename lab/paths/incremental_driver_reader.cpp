// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/incremental_driver_reader.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <span>

#include "lab/base/bad_input.hpp"
#include "lab/base/byte_source.hpp"
#include "lab/base/text.hpp"
#include "lab/paths/incremental_driver_material.hpp"
#include "lab/paths/incremental_driver_path.hpp"
#include "lab/paths/path_reader.hpp"

namespace triax::lab {
namespace {

namespace fs = std::filesystem;

constexpr const char* kParameters = "parameters.inp";
constexpr const char* kStart = "initialconditions.inp";
constexpr std::uint64_t kLargestFile = 64U << 20U;

std::string shown(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : (fs::path(folder) / name).string();
}

std::string text_of_file(const std::string& path) {
  const auto source = open_file(path);
  if (source->size() > kLargestFile) throw BadInput(path, 0, "is larger than 64 MiB");
  std::string text(source->size(), '\0');
  std::size_t got = 0;
  while (got < text.size()) {
    const std::size_t more = source->read(std::span(text).subspan(got));
    if (more == 0) break;
    got += more;
  }
  text.resize(got);
  if (constexpr std::string_view kMark = "\xEF\xBB\xBF"; text.starts_with(kMark))
    text.erase(0, kMark.size());  // of editors that write one
  return text;
}

IncrementalDriverTest read(const InpFile& file, const std::string& test_name,
                           const std::string& folder, const IncrementalDriverSettings& settings) {
  const std::string parameters_name = kParameters, start_name = kStart;
  IncrementalDriverTest test;
  test.files = {test_name, parameters_name, start_name};
  InpLines parameters(file(parameters_name), shown(folder, parameters_name));
  InpLines start(file(start_name), shown(folder, start_name));
  InpLines lines(file(test_name), shown(folder, test_name));
  const InpMaterial inp = read_inp_material(parameters, start);

  const std::string first = lines.required("the name of the output");
  const std::size_t hash = first.find('#');
  test.name = fs::path(inp_before(first, "#")).stem().string();
  if (hash != std::string::npos) test.heading = trimmed(std::string_view(first).substr(hash + 1));
  if (trimmed(first).starts_with('*'))
    lines.fail("the first line must be the name of the output, before any keyword");
  test.path.segments = read_inp_steps(lines, file, test.files, test.warnings);

  InpStart begin = start_from_inp(inp, settings, parameters.name(), folder, test.warnings);
  test.material = std::move(begin.material);
  test.path.stress = inp.stress;
  test.path.void_ratio = begin.void_ratio;
  test.path.memory = std::move(begin.memory);
  for (auto& name : test.files) name = shown(folder, name);
  return test;
}

/// Takes a setting out; the last one given counts.
std::optional<std::string> taken(std::vector<std::pair<std::string, std::string>>& settings,
                                 std::string_view key) {
  std::optional<std::string> value;
  std::erase_if(settings, [&](const auto& one) {
    if (one.first != key) return false;
    value = one.second;
    return true;
  });
  return value;
}

double number_of(std::string_view key, const std::string& text, double lowest, double highest) {
  const auto value = fortran_number(text);
  if (!value || *value < lowest || *value > highest)
    throw BadInput(
        fmt::format("{}={}: must be a number from {} to {}", key, excerpt(text), lowest, highest));
  return *value;
}

}  // namespace

IncrementalDriverTest read_incremental_driver(const InpFile& file, const std::string& folder,
                                              const IncrementalDriverSettings& settings) {
  return read(file, "test.inp", folder, settings);
}

bool is_incremental_driver(const std::string& path) {
  std::error_code none;
  return fs::is_directory(path, none) || folded(fs::path(path).extension().string()) == ".inp";
}

IncrementalDriverTest load_incremental_driver(const std::string& path,
                                              const IncrementalDriverSettings& settings) {
  std::error_code none;
  const bool is_folder = fs::is_directory(path, none);
  if (is_folder && !fs::exists(fs::path(path) / "test.inp", none))
    throw BadInput(path, 0,
                   "is a folder without a test.inp; expected a path file (.toml) or a folder of "
                   "incrementalDriver files");
  const fs::path folder = is_folder ? fs::path(path) : fs::path(path).parent_path();
  const std::string test = is_folder ? "test.inp" : fs::path(path).filename().string();
  if (const std::string name = folded(test); name == kParameters || name == kStart)
    throw BadInput(path, 0, "contains no path; give its folder, or the test.inp in that folder");
  return read([&](const std::string& name) { return text_of_file((folder / name).string()); }, test,
              folder.string(), settings);
}

PathDescription describe_incremental_driver(
    const std::string& path, std::vector<std::pair<std::string, std::string>>& settings) {
  IncrementalDriverSettings own;
  own.umat = taken(settings, "umat").value_or("");
  if (const auto text = taken(settings, "void_ratio"))
    own.void_ratio = number_of("void_ratio", *text, kSmallestVoidRatio, kLargestVoidRatio);
  if (const auto text = taken(settings, "void_ratio_index")) {
    own.void_ratio_index =
        static_cast<int>(number_of("void_ratio_index", *text, 1, sim::kMostMemory));
    if (own.void_ratio_index != number_of("void_ratio_index", *text, 1, sim::kMostMemory))
      throw BadInput("void_ratio_index must be an integer");
  }
  if (!own.umat.empty())
    if (const auto text = taken(settings, "time_limit_s"))
      own.time_limit_s = number_of("time_limit_s", *text, 1e-3, 3600);
  IncrementalDriverTest test = load_incremental_driver(path, own);
  PathDescription description;
  description.name = test.heading.empty() ? test.name : test.heading;
  description.source = path;
  description.files = std::move(test.files);
  description.material = std::move(test.material);
  description.path = std::move(test.path);
  description.warnings = std::move(test.warnings);
  check_length(description);
  return description;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_inputs.hpp"

#include <filesystem>

#include "lab/base/digest.hpp"

namespace triax::study {
namespace {

namespace fs = std::filesystem;

/// The parameters whose text is a file; any other text that happens to be the name of one is not.
constexpr const char* kFileParameters[] = {"umat"};

/// By parameter.
std::vector<std::pair<std::string, std::string>> named(const lab::MaterialSet& material) {
  std::vector<std::pair<std::string, std::string>> found;
  const auto& set = material.parameters;
  for (const char* key : kFileParameters) {
    const auto text = set.texts.find(key);
    if (text == set.texts.end()) continue;
    std::error_code none;
    for (const fs::path& place : {fs::path(set.folder) / text->second, fs::path(text->second)})
      if (fs::is_regular_file(place, none)) {
        found.emplace_back(key, place.string());
        break;
      }
  }
  return found;
}

}  // namespace

std::vector<std::string> files_named_by(const lab::MaterialSet& material) {
  std::vector<std::string> files;
  for (auto& [key, path] : named(material)) files.push_back(std::move(path));
  return files;
}

std::vector<std::pair<std::string, std::string>> digests_of_files(
    const lab::MaterialSet& material) {
  auto found = named(material);
  for (auto& [key, path] : found) path = lab::sha256(*lab::open_file(path));
  return found;
}

}  // namespace triax::study

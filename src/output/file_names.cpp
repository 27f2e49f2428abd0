// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace triax::src {
namespace {

/// File systems allow 255 bytes; a figure's own name, an ending and what a part of a file is called
/// while it is written have to find room, too.
constexpr std::size_t kLongestStem = 120;

std::string in_lower_case(std::string name) {
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  return name;
}

}  // namespace

std::string FileNames::take(const std::string& stem, std::int64_t number) {
  const std::string short_stem = stem.substr(0, kLongestStem);
  const std::string numbered = fmt::format("{}_{}", short_stem, number);
  std::string name = short_stem.size() < stem.size() ? numbered : short_stem;
  if (taken_.contains(in_lower_case(name))) name = numbered;
  for (int i = 2; !taken_.insert(in_lower_case(name)).second; ++i)
    name = fmt::format("{}_{}", numbered, i);
  return name;
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/materials/search_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/base/bad_input.hpp"
#include "lab/base/embedded.hpp"

namespace triax::lab {
namespace {

constexpr double kManyTimes = 20;  // from here on a range is one of ratios

SearchRange range_of(const TomlTable& table, const std::string& key) {
  const auto ends = table.numbers(key);
  if (ends.size() != 2 || !(ends[0] < ends[1]))
    table.fail(key, "must be two numbers, [lowest, highest]");
  return {key, ends[0], ends[1], is_of_ratios(ends[0], ends[1]), {}};
}

void read_prior(const TomlTable& table, const std::string& key, std::vector<SearchRange>& ranges) {
  const auto numbers = table.numbers(key);
  const auto found = std::ranges::find(ranges, key, &SearchRange::key);
  if (found == ranges.end()) table.fail(key, "is not a parameter of [search]");
  if (numbers.size() != 2 || !(numbers[1] > 0))
    table.fail(key, "must be two numbers, [value, standard error above 0]");
  found->prior = {numbers[0], numbers[1]};
}

}  // namespace

bool is_of_ratios(double low, double high) { return low > 0 && high > kManyTimes * low; }

std::vector<SearchRange> read_search(const TomlTable& root) {
  std::vector<SearchRange> ranges;
  if (const auto search = root.table("search"))
    for (const std::string& key : search->keys()) ranges.push_back(range_of(*search, key));
  if (const auto prior = root.table("prior"))
    for (const std::string& key : prior->keys()) read_prior(*prior, key, ranges);
  return ranges;
}

std::vector<SearchRange> read_search(std::string_view toml_text, const std::string& file) {
  return read_search(TomlTable::parse(toml_text, file));
}

std::vector<SearchRange> shipped_search(std::string_view law) {
  for (const EmbeddedFile& file : kShippedMaterials)
    if (file.name == law) return read_search(file.text, std::string(file.name) + ".toml");
  return {};
}

}  // namespace triax::lab

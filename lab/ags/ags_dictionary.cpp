// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_dictionary.hpp"

#include <algorithm>
#include <sstream>

#include "lab/base/embedded.hpp"

namespace triax::lab {
namespace {

std::vector<AgsGroupDefinition> read_dictionary(std::string_view text) {
  std::vector<AgsGroupDefinition> groups;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    std::string name, second;
    words >> name >> second;
    if (line.front() != ' ') {
      groups.push_back({.group = name, .parent = second == "-" ? "" : second, .headings = {}});
      continue;
    }
    AgsDefinition heading{.heading = name};
    heading.key = second.find('K') != std::string::npos;
    heading.required = second.find('R') != std::string::npos;
    words >> heading.type >> heading.unit;
    groups.back().headings.push_back(heading);
  }
  return groups;
}

}  // namespace

const AgsDefinition* AgsGroupDefinition::find(std::string_view heading) const {
  const auto found = std::ranges::find(headings, heading, &AgsDefinition::heading);
  return found == headings.end() ? nullptr : &*found;
}

const std::vector<AgsGroupDefinition>& ags_dictionary() {
  static const auto groups = read_dictionary(kAgsDictionary.front().text);
  return groups;
}

const std::vector<AgsGroupDefinition>& ags_added_in_4_2() {
  static const auto groups = read_dictionary(kAgsDictionary[1].text);
  return groups;
}

const AgsGroupDefinition* ags_definition(std::string_view group) {
  const auto found = std::ranges::find(ags_dictionary(), group, &AgsGroupDefinition::group);
  return found == ags_dictionary().end() ? nullptr : &*found;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "lab/ags/ags_checked_file.hpp"
#include "lab/ags/ags_data_type.hpp"
#include "lab/ags/ags_dictionary.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

using Definitions = std::map<std::string, AgsGroupDefinition>;

std::string cell_of(const AgsCheckedGroup& group, const AgsCheckedRow& row, const char* heading) {
  const auto place = group.place(heading);
  return place < row.cells.size() ? row.cells[place] : std::string();
}

/// What edition the file says it is of, in group TRAN.
std::string edition_of(const AgsCheckedFile& file) {
  const AgsCheckedGroup* const tran = file.find("TRAN");
  return tran == nullptr || tran->rows.empty() ? ""
                                               : cell_of(*tran, tran->rows.front(), "TRAN_AGS");
}

/// Ours, of the file's edition, and behind each group what the file's own DICT adds to it.
Definitions definitions_of(const AgsCheckedFile& file) {
  Definitions all;
  for (const AgsGroupDefinition& group : ags_dictionary()) all[group.group] = group;
  if (edition_of(file) == "4.2")
    for (const AgsGroupDefinition& added : ags_added_in_4_2())
      std::ranges::copy(added.headings, std::back_inserter(all[added.group].headings));
  const AgsCheckedGroup* const dict = file.find("DICT");
  if (dict == nullptr) return all;
  for (const AgsCheckedRow& row : dict->rows) {
    const auto name = cell_of(*dict, row, "DICT_GRP");
    const auto kind = cell_of(*dict, row, "DICT_TYPE");
    // A heading that is added to a group that we do not know defines no group.
    if (kind != "GROUP" && !all.contains(name)) continue;
    AgsGroupDefinition& group = all[name];
    group.group = name;
    if (kind == "GROUP") {
      group.parent = cell_of(*dict, row, "DICT_PGRP");
      continue;
    }
    const auto heading = cell_of(*dict, row, "DICT_HDNG");
    if (group.find(heading) != nullptr) continue;
    const auto status = cell_of(*dict, row, "DICT_STAT");
    group.headings.push_back({.heading = heading,
                              .type = cell_of(*dict, row, "DICT_DTYP"),
                              .unit = cell_of(*dict, row, "DICT_UNIT"),
                              .key = status.find("KEY") != std::string::npos,
                              .required = status.find("REQUIRED") != std::string::npos});
  }
  return all;
}

class DictionaryRules {
 public:
  explicit DictionaryRules(AgsCheckedFile& file) : file_(file), all_(definitions_of(file)) {}

  void check(const AgsCheckedGroup& group) {
    check_types(group);
    const auto found = all_.find(group.name);
    if (found == all_.end()) {
      if (auto& unknown = file_.check.unknown_groups;
          std::ranges::find(unknown, group.name) == unknown.end())
        unknown.push_back(group.name);
      return;
    }
    check_names(group, found->second);
    check_order(group, found->second);
    check_keys(group, found->second);
    check_required(group, found->second);
    check_parents(group, found->second);
  }

 private:
  void wrong(const char* rule, std::int64_t line, const AgsCheckedGroup& group, std::string text) {
    file_.find_wrong(rule, line, group.name, std::move(text));
  }

  void check_types(const AgsCheckedGroup& group) {
    for (std::size_t i = 0; i < group.types.size() && i < group.units.size(); ++i)
      for (const AgsCheckedRow& row : group.rows)
        if (!fits_ags_type(row.cells[i], group.types[i], group.units[i]))
          wrong("8", row.line, group,
                fmt::format("{} has {}, which is not of the type {}", group.headings[i],
                            excerpt(row.cells[i]), group.types[i]));
  }

  void check_names(const AgsCheckedGroup& group, const AgsGroupDefinition& definition) {
    for (const auto& heading : group.headings)
      if (definition.find(heading) == nullptr) {
        wrong("9", group.heading_line, group,
              heading + " is not in the dictionary and not in group DICT");
        if (file_.find("DICT") == nullptr)
          wrong("18", 0, group,
                "headings that are not in the dictionary, and the file has no group DICT");
      } else if (!heading.starts_with(group.name) && !heading.starts_with("SPEC_") &&
                 !heading.starts_with("TEST_") && !of_another(heading)) {
        wrong("19b", group.heading_line, group,
              heading + " begins with the name of another group, which has no such heading");
      }
  }

  bool of_another(const std::string& heading) const {
    const auto owner = all_.find(heading.substr(0, 4));
    // A group that we do not know may have it (GEOL_STAT of SAMP).
    return owner == all_.end() || owner->second.find(heading) != nullptr;
  }

  void check_order(const AgsCheckedGroup& group, const AgsGroupDefinition& definition) {
    std::vector<std::string> wanted;
    for (const AgsDefinition& one : definition.headings)
      if (group.has(one.heading)) wanted.push_back(one.heading);
    for (std::size_t i = 0, at = 0; i < group.headings.size(); ++i) {
      if (definition.find(group.headings[i]) == nullptr) continue;
      if (at < wanted.size() && group.headings[i] != wanted[at])
        return wrong("7", group.heading_line, group,
                     fmt::format("found {}; the dictionary has {}", group.headings[i], wanted[at]));
      ++at;
    }
  }

  static std::string key_text(const AgsCheckedGroup& group, const AgsCheckedRow& row,
                              const std::vector<std::string>& keys) {
    std::string out;
    for (const auto& key : keys) out += cell_of(group, row, key.c_str()) + '\x1F';
    return out;
  }

  static std::vector<std::string> keys_of(const AgsGroupDefinition& definition) {
    std::vector<std::string> keys;
    for (const AgsDefinition& one : definition.headings)
      if (one.key) keys.push_back(one.heading);
    return keys;
  }

  void check_keys(const AgsCheckedGroup& group, const AgsGroupDefinition& definition) {
    const auto keys = keys_of(definition);
    for (const auto& key : keys)
      if (!group.has(key))
        wrong("10a", group.heading_line, group, "the key heading " + key + " is missing");
    std::set<std::string> seen;
    for (const AgsCheckedRow& row : group.rows)
      if (!keys.empty() && !seen.insert(key_text(group, row, keys)).second)
        wrong("10a", row.line, group, "another row has the same key");
  }

  void check_required(const AgsCheckedGroup& group, const AgsGroupDefinition& definition) {
    for (const AgsDefinition& one : definition.headings) {
      if (!one.required) continue;
      if (!group.has(one.heading)) {
        wrong("10b", group.heading_line, group,
              "the required heading " + one.heading + " is missing");
        continue;
      }
      for (const AgsCheckedRow& row : group.rows)
        if (trimmed(row.cells[group.place(one.heading)]).empty())
          wrong("10b", row.line, group, one.heading + " is required and empty");
    }
  }

  void check_parents(const AgsCheckedGroup& group, const AgsGroupDefinition& definition) {
    constexpr std::string_view kRoot = "PROJ";
    if (definition.parent.empty() || definition.parent == "-" || definition.parent == kRoot) return;
    const auto parent = all_.find(definition.parent);
    if (parent == all_.end()) return;
    const AgsCheckedGroup* const above = file_.find(definition.parent);
    if (above == nullptr)
      return wrong("10c", group.line, group,
                   "the file has no group " + definition.parent + ", its parent");
    const auto keys = keys_of(parent->second);
    std::set<std::string> known;
    for (const AgsCheckedRow& row : above->rows) known.insert(key_text(*above, row, keys));
    for (const AgsCheckedRow& row : group.rows)
      if (!known.contains(key_text(group, row, keys)))
        wrong("10c", row.line, group, "no row of " + definition.parent + " has its key");
  }

  AgsCheckedFile& file_;
  Definitions all_;
};

}  // namespace

void check_by_dictionary(AgsCheckedFile& file) {
  DictionaryRules rules(file);
  for (auto& group : file.groups) rules.check(group);
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "lab/ags/ags_checked_file.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

/// All that stands below a heading of a group; empty where the file has neither.
std::set<std::string> below(const AgsCheckedFile& file, const char* group, const char* heading) {
  std::set<std::string> out;
  const AgsCheckedGroup* const found = file.find(group);
  if (found == nullptr || !found->has(heading)) return out;
  for (const AgsCheckedRow& row : found->rows) out.insert(row.cells[found->place(heading)]);
  return out;
}

void check_one_row(AgsCheckedFile& file, const char* rule, const char* name) {
  const AgsCheckedGroup* const group = file.find(name);
  if (group == nullptr)
    file.find_wrong(rule, 0, name, fmt::format("the file has no group {}", name));
  else if (group->rows.size() != 1)
    file.find_wrong(rule, group->line, name,
                    fmt::format("{} rows of DATA; expected one", group->rows.size()));
}

/// Rules 15 and 17: what the UNIT or TYPE rows use is listed.
void check_listed(AgsCheckedFile& file, const char* rule, const char* list, const char* heading,
                  std::vector<std::string> AgsCheckedGroup::*used, const char* what) {
  if (file.find(list) == nullptr)
    return file.find_wrong(rule, 0, list, fmt::format("the file has no group {}", list));
  std::set<std::string> known = below(file, list, heading);
  known.insert("");
  for (const AgsCheckedGroup& group : file.groups)
    for (const std::string& one : group.*used)
      if (known.insert(one).second)
        file.find_wrong(
            rule, 0, group.name,
            fmt::format("the {} {} is not listed in group {}", what, excerpt(one), list));
}

std::vector<std::string> parts(std::string_view text, std::string_view mark) {
  std::vector<std::string> out;
  while (!mark.empty()) {
    const auto end = text.find(mark);
    if (end == std::string_view::npos) break;
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(end + mark.size());
  }
  out.emplace_back(text);
  return out;
}

void check_abbreviations(AgsCheckedFile& file) {
  std::set<std::pair<std::string, std::string>> known;
  if (const AgsCheckedGroup* const abbr = file.find("ABBR");
      abbr != nullptr && abbr->has("ABBR_HDNG") && abbr->has("ABBR_CODE"))
    for (const AgsCheckedRow& row : abbr->rows)
      known.emplace(row.cells[abbr->place("ABBR_HDNG")], row.cells[abbr->place("ABBR_CODE")]);
  const auto joins = below(file, "TRAN", "TRAN_RCON");
  const std::string mark = joins.empty() ? "" : *joins.begin();
  for (const AgsCheckedGroup& group : file.groups)
    for (std::size_t i = 0; i < group.types.size(); ++i) {
      if (group.types[i] != "PA") continue;
      for (const AgsCheckedRow& row : group.rows)
        for (const std::string& code : parts(row.cells[i], mark))
          if (!code.empty() && known.emplace(group.headings[i], code).second)
            file.find_wrong("16", row.line, group.name,
                            fmt::format("the abbreviation {} of {} is not in group ABBR",
                                        excerpt(code), group.headings[i]));
    }
}

void check_transmission(AgsCheckedFile& file) {
  const bool links = std::ranges::any_of(file.groups, [](const AgsCheckedGroup& group) {
    return std::ranges::find(group.types, "RL") != group.types.end();
  });
  const auto empty = [&](const char* heading) {
    const auto values = below(file, "TRAN", heading);
    return values.empty() || values.contains("");
  };
  if (links && empty("TRAN_DLIM"))
    file.find_wrong("11a", 0, "TRAN", "record links need the delimiter in TRAN_DLIM");
  if (links && empty("TRAN_RCON"))
    file.find_wrong("11b", 0, "TRAN", "record links need the concatenator in TRAN_RCON");
}

void check_file_sets(AgsCheckedFile& file) {
  auto known = below(file, "FILE", "FILE_FSET");
  known.insert("");
  for (const AgsCheckedGroup& group : file.groups) {
    if (group.name == "FILE" || !group.has("FILE_FSET")) continue;
    for (const AgsCheckedRow& row : group.rows)
      if (const auto& set = row.cells[group.place("FILE_FSET")]; known.insert(set).second)
        file.find_wrong("20", row.line, group.name,
                        fmt::format("the set of files {} is not in group FILE", excerpt(set)));
  }
}

}  // namespace

void check_needed_groups(AgsCheckedFile& file) {
  for (std::size_t i = 0; i < file.groups.size(); ++i)
    if (file.groups[i].rows.empty())
      file.find_wrong("2", file.groups[i].line, file.groups[i].name, "no row of DATA");
  check_one_row(file, "13", "PROJ");
  check_one_row(file, "14", "TRAN");
  check_listed(file, "15", "UNIT", "UNIT_UNIT", &AgsCheckedGroup::units, "unit");
  check_abbreviations(file);
  check_listed(file, "17", "TYPE", "TYPE_TYPE", &AgsCheckedGroup::types, "type");
  check_transmission(file);
  check_file_sets(file);
}

}  // namespace triax::lab

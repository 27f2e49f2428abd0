// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_checked_file.hpp"
#include "lab/intake/text/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "lab/ags/ags_line.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr std::uint64_t kLargestChecked = std::uint64_t{64} << 20;

std::string all_of(ByteSource& source) {
  if (source.size() > kLargestChecked)
    throw BadInput(source.name(), 0,
                   "larger than 64 MB; check the groups of the delivery separately");
  source.rewind();
  std::string bytes(source.size(), '\0');
  std::size_t taken = 0;
  while (const auto count = source.read({bytes.data() + taken, bytes.size() - taken}))
    taken += count;
  bytes.resize(taken);
  if (bytes.find('\0') != std::string::npos)
    throw BadInput(source.name(), 0, "NUL bytes found: this is not a text file");
  return bytes;
}

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_name_sign(char c) { return is_capital(c) || (c >= '0' && c <= '9') || c == '_'; }

/// Takes a file line by line.
class LineRules {
 public:
  explicit LineRules(AgsCheckedFile& file) : file_(file) {}

  void take(std::string_view line, bool ended_by_cr_lf) {
    ++line_;
    if (!ended_by_cr_lf && !std::exchange(told_line_end_, true))
      wrong("2a", "the line does not end with CR LF (reported once)");
    if (std::ranges::any_of(line, [](char c) { return static_cast<unsigned char>(c) > 0x7E; }))
      wrong("1", "a character that is not ASCII (a byte-order mark, an accent, a sign)");
    if (line.empty()) return;
    if (trimmed(line).empty()) return wrong("5", "a line of spaces only");
    cells_.clear();
    if (const auto broken = split_ags_line(line, cells_); !broken.empty())
      return wrong("5", broken);
    check_quotes(line);
    const std::string kind = cells_.front();
    cells_.erase(cells_.begin());
    if (kind == "GROUP") return begin_group();
    if (kind == "HEADING") return take_headings();
    if (kind == "UNIT" || kind == "TYPE") return take_units_or_types(kind);
    if (kind == "DATA") return take_data();
    wrong("3", "begins with " + excerpt(kind) +
                   "; a line begins with GROUP, HEADING, UNIT, TYPE or DATA");
  }

 private:
  void wrong(const char* rule, std::string text) {
    file_.find_wrong(rule, line_, file_.groups.empty() ? "" : file_.groups.back().name,
                     std::move(text));
  }

  /// Written again with all quotes, the line must be what it was.
  void check_quotes(std::string_view line) {
    std::string again;
    for (const auto& cell : cells_) {
      again += again.empty() ? "\"" : ",\"";
      for (const char c : cell) again.append(c == '"' ? 2 : 1, c);
      again += '"';
    }
    if (again != line) wrong("5", "a field without quotes, or spaces between fields");
  }

  void begin_group() {
    if (cells_.size() != 1)
      return wrong("4",
                   fmt::format("the GROUP row has {} fields after its descriptor; expected one",
                               cells_.size()));
    const std::string& name = cells_.front();
    if (name.size() != 4 || !std::ranges::all_of(name, is_capital))
      wrong("19", "the name of the group is " + excerpt(name) + "; expected four capital letters");
    if (++seen_groups_[name] == 2)
      wrong("4", "group " + excerpt(name) + " appears twice or more (reported once)");
    file_.groups.push_back({.name = name, .line = line_});
  }

  AgsCheckedGroup* group_of(const char* kind) {
    if (!file_.groups.empty()) return &file_.groups.back();
    wrong("4", fmt::format("a {} row before the first GROUP row", kind));
    return nullptr;
  }

  void take_headings() {
    AgsCheckedGroup* const group = group_of("HEADING");
    if (group == nullptr) return;
    if (group->heading_line > 0) return wrong("4", "a second HEADING row");
    group->heading_line = line_;
    group->headings = cells_;
    std::set<std::string> seen;
    for (const auto& name : cells_) {
      if (!seen.insert(name).second) wrong("7", "heading " + excerpt(name) + " appears twice");
      if (name.empty() || name.size() > 9 || !std::ranges::all_of(name, is_name_sign))
        wrong("19a", "the heading " + excerpt(name) +
                         " must have at most nine capital letters, digits and underscores");
      else if (name.size() < 6 || name[4] != '_' || name.find('_', 5) != std::string::npos)
        wrong("19b", "the heading " + excerpt(name) +
                         " is not the name of a group, an underscore and up to four characters");
    }
  }

  bool fits(AgsCheckedGroup* group, const char* kind) {
    if (group->heading_line == 0)
      wrong("4", fmt::format("a {} row before the HEADING row", kind));
    else if (cells_.size() != group->headings.size())
      wrong("4", fmt::format("the {} row has {} fields where the HEADING row has {}", kind,
                             cells_.size(), group->headings.size()));
    else
      return true;
    return false;
  }

  void take_units_or_types(const std::string& kind) {
    AgsCheckedGroup* const group = group_of(kind.c_str());
    if (group == nullptr || !fits(group, kind.c_str())) return;
    const bool units = kind == "UNIT";
    std::int64_t& at = units ? group->unit_line : group->type_line;
    if (at > 0) return wrong("4", "a second " + kind + " row");
    const std::int64_t above = units ? group->heading_line : group->unit_line;
    if (above + 1 != line_)
      wrong("2b", fmt::format("the {} row must follow the {} row directly", kind,
                              units ? "HEADING" : "UNIT"));
    at = line_;
    (units ? group->units : group->types) = cells_;
  }

  void take_data() {
    AgsCheckedGroup* const group = group_of("DATA");
    if (group != nullptr && fits(group, "DATA")) group->rows.push_back({line_, cells_});
  }

  AgsCheckedFile& file_;
  std::int64_t line_ = 0;
  bool told_line_end_ = false;
  std::map<std::string, int> seen_groups_;
  std::vector<std::string> cells_;
};

}  // namespace

std::size_t AgsCheckedGroup::place(std::string_view heading) const {
  return static_cast<std::size_t>(std::ranges::find(headings, heading) - headings.begin());
}

const AgsCheckedGroup* AgsCheckedFile::find(std::string_view name) const {
  const auto found = std::ranges::find(groups, name, &AgsCheckedGroup::name);
  return found == groups.end() ? nullptr : &*found;
}

void AgsCheckedFile::find_wrong(std::string rule, std::int64_t line, std::string group,
                                std::string text) {
  if (check.findings.size() < kMostAgsFindings)
    check.findings.push_back({std::move(rule), line, std::move(group), std::move(text)});
}

AgsCheckedFile read_checked_file(ByteSource& source) {
  AgsCheckedFile file;
  const std::string bytes = all_of(source);
  if (begins_ags3(std::string_view(bytes).substr(bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0)))
    throw BadInput(source.name(), 1, kRefuseAgs3);
  LineRules rules(file);
  std::string_view rest = bytes;
  while (!rest.empty()) {
    const auto end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    const bool cr = line.ends_with('\r');
    if (cr) line.remove_suffix(1);
    rules.take(line, cr && end != std::string_view::npos);
  }
  for (const AgsCheckedGroup& group : file.groups) {
    if (group.heading_line == 0) file.find_wrong("4", group.line, group.name, "no HEADING row");
    if (group.unit_line == 0) file.find_wrong("2b", group.line, group.name, "no UNIT row");
    if (group.type_line == 0) file.find_wrong("2b", group.line, group.name, "no TYPE row");
  }
  return file;
}

AgsCheck check_ags(ByteSource& source) {
  AgsCheckedFile file = read_checked_file(source);
  check_needed_groups(file);
  check_by_dictionary(file);
  std::ranges::stable_sort(file.check.findings, {}, &AgsFinding::line);
  return std::move(file.check);
}

std::string in_words(const AgsFinding& finding) {
  std::string out = finding.line > 0 ? fmt::format("line {}, ", finding.line) : std::string();
  out += "rule " + finding.rule;
  if (!finding.group.empty()) out += ", " + finding.group;
  return out + ": " + finding.text;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_reader.hpp"
#include "lab/intake/text/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "lab/ags/ags_line.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr char kEndMarkOfDos = '\x1A';
/// The standard has 150 or so; more are no file of a ground investigation.
constexpr std::size_t kMaxGroups = 2000;
constexpr std::array<std::string_view, 5> kRowKinds{"GROUP", "HEADING", "UNIT", "TYPE", "DATA"};

std::string_view first_cell(std::string_view line) {
  std::string_view cell = trimmed(line.substr(0, line.find(',')));
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

}  // namespace

std::optional<std::size_t> AgsGroup::find(std::string_view heading) const {
  const auto found = std::ranges::find(headings, heading, &AgsHeading::name);
  if (found == headings.end()) return std::nullopt;
  return static_cast<std::size_t>(found - headings.begin());
}

std::string_view AgsReader::cell(std::string_view heading) const {
  const auto column = group_.find(heading);
  return column ? trimmed(cells_[*column]) : std::string_view{};
}

void AgsReader::fail(const std::string& what) const { throw BadInput(file(), line(), what); }

bool AgsReader::next() {
  std::string_view line;
  while (next_line(line))
    if (take(line)) return true;
  return false;
}

bool AgsReader::next_line(std::string_view& line) {
  do {
    if (!lines_.next(line)) return false;
    if (line.starts_with(kEndMarkOfDos)) return false;
    if (lines_.cut_off() && line.ends_with(kEndMarkOfDos)) line.remove_suffix(1);
  } while (trimmed(line).empty());
  if (is_utf8(line)) return true;
  if (recoded_line_ == 0) recoded_line_ = lines_.line_number();
  utf8_ = utf8_from_cp1252(line);
  line = utf8_;
  return true;
}

/// True for a row of data.
bool AgsReader::take(std::string_view line) {
  if (begins_ags3(line)) fail(kRefuseAgs3);
  if (const auto wrong = split_ags_line(line, cells_); !wrong.empty()) fail(wrong);
  const std::string row(trimmed(cells_.front()));
  if (std::ranges::find(kRowKinds, row) == kRowKinds.end())
    fail("the line begins with " + excerpt(row) +
         "; a line of AGS4 begins with GROUP, HEADING, UNIT, TYPE or DATA");
  cells_.erase(cells_.begin());
  if (row == "GROUP") {
    begin_group();
    return false;
  }
  if (group_.name.empty()) fail("a " + row + " row before the first GROUP row");
  if (row == "HEADING") {
    take_headings();
    return false;
  }
  require_headings(row);
  fit_cells(row);
  has_data_ = row == "DATA";
  if (!has_data_) take_units_or_types(row == "UNIT");
  return has_data_;
}

void AgsReader::begin_group() {
  while (!cells_.empty() && trimmed(cells_.back()).empty()) cells_.pop_back();
  if (cells_.size() != 1)
    fail(fmt::format("the GROUP row has {} cells; expected one, the name of the group",
                     cells_.size()));
  group_ = {.name = std::string(trimmed(cells_.front())), .headings = {}};
  has_data_ = false;
  if (std::ranges::find(names_, group_.name) != names_.end()) return;
  if (names_.size() == kMaxGroups)
    fail(fmt::format("more than {} groups: this is not a file of a ground investigation",
                     kMaxGroups));
  names_.push_back(group_.name);
}

void AgsReader::take_headings() {
  if (!group_.headings.empty()) fail("a second HEADING row in group " + excerpt(group_.name));
  while (!cells_.empty() && trimmed(cells_.back()).empty()) cells_.pop_back();
  if (cells_.empty()) fail("the HEADING row of group " + excerpt(group_.name) + " is empty");
  std::set<std::string_view> seen;
  for (const std::string& cell : cells_) {
    const std::string_view name = trimmed(cell);
    if (name.empty())
      fail("the HEADING row of group " + excerpt(group_.name) + " has an empty cell");
    if (!seen.insert(name).second)
      fail("heading " + excerpt(name) + " appears twice in group " + excerpt(group_.name));
    group_.headings.push_back({.name = std::string(name), .unit = {}, .type = {}});
  }
}

void AgsReader::take_units_or_types(bool units) {
  std::int64_t& taken = units ? group_.unit_line : group_.type_line;
  const char* const row = units ? "UNIT" : "TYPE";
  if (taken != 0) fail(fmt::format("a second {} row in group {}", row, excerpt(group_.name)));
  taken = line();
  for (std::size_t i = 0; i < cells_.size(); ++i)
    (units ? group_.headings[i].unit : group_.headings[i].type) = trimmed(cells_[i]);
}

void AgsReader::require_headings(const std::string& row) const {
  if (group_.headings.empty())
    fail(fmt::format("a {} row before the HEADING row of group {}", row, excerpt(group_.name)));
  if (row != "DATA" && has_data_)
    fail(fmt::format("a {} row below the first DATA row of group {}", row, excerpt(group_.name)));
}

/// What a spreadsheet appends is empty.
void AgsReader::fit_cells(const std::string& row) {
  while (cells_.size() > group_.headings.size() && trimmed(cells_.back()).empty())
    cells_.pop_back();
  if (cells_.size() != group_.headings.size())
    fail(fmt::format("the {} row has {} cells; group {} has {} headings", row, cells_.size(),
                     excerpt(group_.name), group_.headings.size()));
}

bool looks_like_ags(ByteSource& source) {
  LineReader lines(source);
  std::string_view line;
  try {
    do {
      if (!lines.next(line)) return false;
    } while (trimmed(line).empty());
  } catch (const BadInput&) {
    return false;  // no text in UTF-8
  }
  if (begins_ags3(line)) return true;
  const std::string_view cell = first_cell(line);
  if (cell == "GROUP") return true;
  return folded(source.name()).ends_with(".ags") &&
         std::ranges::find(kRowKinds, cell) != kRowKinds.end();
}

}  // namespace triax::lab

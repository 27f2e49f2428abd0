// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/table_layout.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/line_reader.hpp"
#include "lab/base/text.hpp"
#include "lab/records/channels.hpp"
#include "lab/records/column_plan.hpp"

namespace triax::lab {
namespace {

using Cells = std::vector<std::string_view>;
constexpr std::array kCandidates{Separator::tab, Separator::semicolon, Separator::comma,
                                 Separator::blanks, Separator::wide_blanks};

/// The line without the marks that some put before headings: "** eps1", "# time".
std::string_view heading_text(std::string_view line) {
  const auto text = line.find_first_not_of("*#%");
  const bool marked = text != std::string_view::npos && text > 0 && line[text] == ' ';
  return marked ? line.substr(text) : line;
}

struct Head {
  std::vector<std::string> lines;  // UTF-8
  bool whole_file = false;
};

Head read_head(ByteSource& source, Findings& findings) {
  constexpr std::size_t kMostBytes = std::size_t{4} << 20;
  Head head;
  LineReader reader(source);
  std::string_view line;
  std::size_t bytes = 0;
  bool utf8 = true;
  bool text = false;
  while (head.lines.size() < kLongestHead && bytes < kMostBytes) {
    if (!reader.next(line)) {
      head.whole_file = true;
      break;
    }
    head.lines.emplace_back(line);
    bytes += line.size();
    utf8 = utf8 && is_utf8(line);
    text = text || !trimmed(line).empty();
  }
  if (!text && head.whole_file)
    throw BadInput(source.name(), 0, "the file is empty; expected a line of headings and rows");
  if (!utf8) {
    const auto first =
        std::ranges::find_if(head.lines, [](const auto& one) { return !is_utf8(one); });
    findings.note("encoding", first - head.lines.begin() + 1, "not UTF-8: read as Windows-1252");
    for (auto& one : head.lines) one = utf8_from_cp1252(one);
  }
  return head;
}

// One heading line read with one separator.
struct Candidate {
  const Dialect* dialect = nullptr;
  std::size_t line = 0;
  Separator separator = Separator::comma;
  std::size_t known = 0;  // headings that this dialect understands
};

bool has_headings(const Dialect& dialect, const Cells& cells) {
  return std::ranges::all_of(dialect.headings, [&](const std::string& name) {
    return std::ranges::any_of(cells, [&](std::string_view cell) {
      return may_match(cell, name) &&
             (matches_name(cell, name) || matches_name(split_heading(cell).name, name));
    });
  });
}

bool is_comment(const Dialect& dialect, std::string_view line) {
  return !dialect.comment.empty() && line.starts_with(dialect.comment);
}

bool holds_texts(const Dialect& dialect, const Head& head, std::size_t line) {
  return std::ranges::all_of(dialect.contains, [&](const std::string& text) {
    return std::any_of(head.lines.begin(),
                       head.lines.begin() + static_cast<std::ptrdiff_t>(line) + 1,
                       [&](const auto& one) { return one.find(text) != std::string::npos; });
  });
}

std::optional<Candidate> find_heading_line(const Dialect& dialect, const Head& head) {
  constexpr std::size_t kFewestKnown = 2;
  std::vector<Separator> separators(std::begin(kCandidates), std::end(kCandidates));
  if (dialect.separator != Separator::automatic) separators = {dialect.separator};
  if (dialect.heading_separator != Separator::automatic) separators = {dialect.heading_separator};
  std::optional<Candidate> best;
  Cells cells;
  for (std::size_t line = 0; line < head.lines.size(); ++line) {
    if (is_comment(dialect, head.lines[line])) continue;
    for (const Separator separator : separators) {
      split_cells(heading_text(head.lines[line]), separator, cells);
      if (!has_headings(dialect, cells) || !holds_texts(dialect, head, line)) continue;
      const auto known = count_known(dialect, cells);
      if (known < kFewestKnown || (best && known <= best->known)) continue;
      best = Candidate{&dialect, line, separator, known};
    }
    if (best && !dialect.headings.empty()) break;
  }
  return best;
}

// Our own headings behind another separator: told by name, because no heading is wrong then.
void refuse_other_separator(const ByteSource& source, const Head& head) {
  for (Dialect dialect : shipped_dialects()) {
    if (!dialect.own_headings) continue;
    dialect.separator = Separator::automatic;
    const auto found = find_heading_line(dialect, head);
    if (!found) continue;
    throw BadInput(
        source.name(), static_cast<std::int64_t>(found->line) + 1,
        fmt::format(
            "the headings are those of triax, but the columns are separated by '{}'; the "
            "CSV format of triax uses commas as separator and decimal points. Change the "
            "file, or describe it as a dialect (docs/reference/record-files.md, table.separator)",
            character(found->separator)));
  }
}

[[noreturn]] void nothing_fits(const ByteSource& source, const Head& head,
                               const std::optional<Dialect>& forced) {
  // The line with the most cells that are words is the likeliest line of headings.
  Cells cells;
  Cells best;
  std::size_t best_line = 0;
  for (std::size_t line = 0; line < head.lines.size(); ++line)
    for (const Separator separator : kCandidates) {
      split_cells(heading_text(head.lines[line]), separator, cells);
      std::erase_if(cells, [](std::string_view cell) {
        DecimalMark mark = DecimalMark::open;
        double value = 0;
        return parse_cell(cell, mark, value) != CellKind::text;
      });
      if (character(separator) == 0 && !best.empty()) continue;
      if (cells.size() <= best.size()) continue;
      best = cells;
      best_line = line;
    }
  constexpr std::size_t kMostShown = 12;
  std::vector<std::string> shown;
  for (const auto cell : best)
    if (shown.size() < kMostShown) shown.push_back(excerpt(cell));
  if (best.size() > kMostShown) shown.push_back(fmt::format("... {} in all", best.size()));
  if (best.size() == 1)
    throw BadInput(source.name(), static_cast<std::int64_t>(best_line) + 1,
                   "only one column found (" + shown.front() +
                       "); columns are separated by comma, semicolon, tab or spaces");
  const auto who = forced ? "the dialect '" + forced->name + "' does not fit this file"
                          : std::string("no dialect fits this file");
  throw BadInput(
      source.name(), best.empty() ? 0 : static_cast<std::int64_t>(best_line) + 1,
      fmt::format("{}; headings found: {}. Describe the file in a few lines of TOML and give them "
                  "with --dialect FILE.toml: name = \"...\", [columns] axial_strain = {{ names = "
                  "\"its heading\", unit = \"%\" }}, ... (docs/reference/record-files.md)",
                  who, shown.empty() ? "none" : joined(shown)));
}

// The unit that a units row states for a cell: its first bracket, or the whole of it.
std::optional<std::string> unit_in_cell(std::string_view cell) {
  const auto open = cell.find_first_of("([");
  if (open == std::string_view::npos) {
    if (cell.empty()) return std::nullopt;
    return std::string(cell);
  }
  const auto close = cell.find_first_of(")]", open);
  if (close == std::string_view::npos) return std::nullopt;
  return std::string(trimmed(cell.substr(open + 1, close - open - 1)));
}

// The units of the line, if it is a units row: no numbers, at least one unit.
std::vector<std::optional<std::string>> units_row(std::string_view line, Separator separator) {
  Cells cells;
  split_cells(line, separator, cells);
  std::vector<std::optional<std::string>> units;
  bool any = false;
  for (const auto cell : cells) {
    DecimalMark mark = DecimalMark::open;
    double value = 0;
    if (parse_cell(cell, mark, value) == CellKind::number) return {};
    units.push_back(unit_in_cell(cell));
    any = any || (units.back() && !units.back()->empty() && sim::find_unit(*units.back()));
  }
  return any ? units : std::vector<std::optional<std::string>>{};
}

// Where headings are set apart in another way than rows, the first row tells how.
Separator row_separator(const TableLayout& layout, std::string_view row) {
  if (layout.dialect.separator != Separator::automatic) return layout.dialect.separator;
  if (layout.dialect.heading_separator == Separator::automatic &&
      layout.heading_separator != Separator::wide_blanks)
    return layout.heading_separator;
  Cells cells;
  for (const Separator separator : kCandidates) {
    split_cells(row, separator, cells);
    if (cells.size() == layout.cell_count) return separator;
  }
  return Separator::blanks;
}

}  // namespace

bool TableLayout::has(ColumnRole role) const {
  return std::ranges::find(columns, role, &PlannedColumn::role) != columns.end();
}

std::vector<Quantity> TableLayout::quantities() const {
  std::vector<Quantity> out;
  for (const PlannedColumn& column : columns)
    if (column.role == ColumnRole::quantity) out.push_back(column.quantity);
  return out;
}

TableLayout recognise_table(ByteSource& source, const std::optional<Dialect>& forced,
                            Findings& findings) {
  const Head head = read_head(source, findings);
  std::optional<Candidate> best;
  if (forced) {
    best = find_heading_line(*forced, head);
  } else {
    for (const Dialect& dialect : shipped_dialects()) {
      const auto found = find_heading_line(dialect, head);
      if (found && (!best || found->known > best->known)) best = found;
    }
  }
  if (!best && !forced) refuse_other_separator(source, head);
  if (!best) nothing_fits(source, head, forced);

  TableLayout layout;
  layout.dialect = *best->dialect;
  layout.file = source.name();
  layout.heading_line = static_cast<std::int64_t>(best->line) + 1;
  layout.heading_separator = best->separator;
  const auto& lines = head.lines;
  layout.head.assign(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(best->line));

  auto row = best->line + 1;
  const auto skip = [&] {
    while (row < lines.size() &&
           (trimmed(lines[row]).empty() || is_comment(layout.dialect, lines[row])))
      ++row;
  };
  layout.first_row_line = static_cast<std::int64_t>(row) + 1;
  skip();
  std::vector<std::optional<std::string>> units;
  if (row < lines.size()) units = units_row(lines[row], layout.heading_separator);
  if (!units.empty()) {
    layout.first_row_line = static_cast<std::int64_t>(++row) + 1;
    skip();
  }
  if (row >= lines.size() && head.whole_file)
    throw BadInput(layout.file, layout.heading_line,
                   "headings without a row of readings; the record is empty");
  const auto unknown = plan_columns(layout, heading_text(lines[best->line]), units, findings);
  layout.separator = row_separator(layout, row < lines.size() ? lines[row] : std::string());
  if (const auto missing = missing_channels(layout.quantities()); !missing.empty())
    throw BadInput(layout.file, layout.heading_line,
                   joined({missing, joined(unknown, "; ")}, "; "));
  return layout;
}

}  // namespace triax::lab

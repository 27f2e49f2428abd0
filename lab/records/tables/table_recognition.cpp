// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/tables/table_recognition.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/line_reader.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/cells/fill_values.hpp"
#include "lab/intake/gauge_columns.hpp"
#include "lab/intake/names/unit_names.hpp"
#include "lab/intake/text/row_model.hpp"
#include "lab/intake/text/structure.hpp"
#include "lab/records/channels.hpp"
#include "lab/records/clock_columns.hpp"
#include "lab/records/column_plan.hpp"
#include "lab/records/proposed_layout.hpp"
#include "lab/records/rows/find_reversed_rows.hpp"

namespace triax::lab {
namespace {

using Cells = std::vector<std::string_view>;
constexpr std::array kCandidates{Separator::tab,    Separator::semicolon,   Separator::comma,
                                 Separator::blanks, Separator::wide_blanks, Separator::pipe};

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

Head read_head(ByteSource& source) {
  constexpr std::size_t kMaxHead_bytes = std::size_t{4} << 20;
  Head head;
  LineReader reader(source);
  std::string_view line;
  std::size_t bytes = 0;
  bool text = false;
  while (head.lines.size() < kMaxHead_lines && bytes < kMaxHead_bytes) {
    if (!reader.next(line)) {
      head.whole_file = true;
      break;
    }
    head.lines.emplace_back(line);
    bytes += line.size();
    text = text || !trimmed(line).empty();
  }
  if (!text && head.whole_file)
    throw BadInput(source.name(), 0, "the file is empty; expected a line of headings and rows");
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
  return begins_with_comment(line, dialect.comment);
}

bool holds_texts(const Dialect& dialect, const Head& head, std::size_t line) {
  return std::ranges::all_of(dialect.contains, [&](const std::string& text) {
    return std::any_of(head.lines.begin(),
                       head.lines.begin() + static_cast<std::ptrdiff_t>(line) + 1,
                       [&](const auto& one) { return one.find(text) != std::string::npos; });
  });
}

std::optional<Candidate> find_heading_line(const Dialect& dialect, const Head& head) {
  constexpr std::size_t kMinKnownHeadings = 2;
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
      if (dialect.own_headings && !has_own_heading(cells)) continue;  // "Stage", "Time (s)"
      const auto known = count_known(dialect, cells);
      if (known < kMinKnownHeadings || (best && known <= best->known)) continue;
      best = Candidate{&dialect, line, separator, known};
    }
    if (best && !dialect.headings.empty()) break;
  }
  return best;
}

// Our own headings between other separators: the headings are right, so the separator is named.
void refuse_other_separator(const ByteSource& source, const Head& head, Separator separator) {
  if (separator == Separator::comma) return;
  for (Dialect dialect : shipped_dialects()) {
    if (!dialect.own_headings) continue;
    dialect.separator = separator;
    const auto found = find_heading_line(dialect, head);
    if (!found) continue;
    throw BadInput(
        source.name(), static_cast<std::int64_t>(found->line) + 1,
        fmt::format(
            "the headings are those of triax, but the columns are separated by {}; the "
            "CSV format of triax uses commas as separator and decimal points. Change the "
            "file, or describe it as a dialect (docs/reference/foreign-tables.md, table.separator)",
            separator_name(separator)));
  }
}

// "headings found: 'a', 'b'; 10 rows ..." of the table that the file has, or why it has none.
std::string describe(const StructureResult& found) {
  constexpr std::size_t kMaxShown = 12;
  if (!found.structure || !found.reason.empty()) return "found: " + found.reason;
  const TableStructure& table = *found.structure;
  std::vector<std::string> shown;
  for (const std::string& heading : table.headings)
    if (shown.size() < kMaxShown) shown.push_back(excerpt(heading));
  if (table.column_count > kMaxShown) shown.emplace_back("...");
  return fmt::format("headings found: {} ({} columns separated by {}, rows from line {})",
                     joined(shown), table.column_count, separator_name(table.separator),
                     table.first_row_line);
}

[[noreturn]] void nothing_fits(const ByteSource& source, const StructureResult& found,
                               const std::optional<Dialect>& forced) {
  const auto line = found.structure && !found.structure->heading_lines.empty()
                        ? found.structure->heading_lines.back()
                        : 0;
  if (!found.structure && found.reason == "one column")
    throw BadInput(source.name(), 0,
                   "only one column found; columns are separated by comma, semicolon, tab, | or "
                   "spaces");
  const auto who = forced ? "the dialect '" + forced->name + "' does not fit this file"
                          : std::string("no dialect fits this file");
  throw BadInput(
      source.name(), line,
      fmt::format("{}; {}. Describe the file in a few lines of TOML and give them "
                  "with --dialect FILE.toml: name = \"...\", [columns] axial_strain = "
                  "{{ {}, unit = \"%\" }}, ... (docs/reference/foreign-tables.md)",
                  who, describe(found), line > 0 ? "names = \"its heading\"" : "column = 1"));
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
    any = any || (units.back() && !units.back()->empty() &&
                  (sim::find_unit(*units.back()) || !find_unit_names(*units.back()).empty()));
  }
  return any ? units : std::vector<std::optional<std::string>>{};
}

// The separator of the rows: the first row shows it if headings are separated in another way.
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

void check_channels(const TableLayout& layout) {
  const auto found = layout.quantities();
  if (const auto missing = missing_channels(found); !missing.empty() && !may_be_total_stress(found))
    throw BadInput(layout.file, layout.heading_line, joined({missing, layout.ignored}, "; "));
}

/// A table with fewer known columns is none of readings.
constexpr std::ptrdiff_t kMinUsedColumns = 2;

std::ptrdiff_t used_columns(const Proposal& proposal) {
  const auto gauges = static_cast<std::ptrdiff_t>(find_gauge_columns(proposal).size());
  return gauges + std::ranges::count_if(proposal.meaning.columns, [](const ColumnMeaning& column) {
           const auto* const quantity = column.reading.quantity;
           return quantity &&
                  (find_quantity(quantity->name) || find_source_quantity(quantity->name));
         });
}

/// The table to be read, of those side by side.
std::size_t chosen_block(const ByteSource& source, const TableStructure& structure,
                         const TableTest& test) {
  const std::size_t count = structure.blocks.size();
  if (count > 1 && test.block == 0)
    throw SeveralTests(source.name(), 0,
                       fmt::format("{} tables are side by side, each a test of its own; triax "
                                   "replay FILE reads them all",
                                   count));
  if (test.block > count)
    throw BadInput(source.name(), 0,
                   fmt::format("there is no table {} of {} side by side", test.block, count));
  return test.block;
}

/// The lines of headings and units, which can come again between the rows.
std::vector<std::string> heading_texts(const TableSample& sample, const TableStructure& structure) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const auto number = sample.number(i);
    if (number == structure.unit_line ||
        std::ranges::find(structure.heading_lines, number) != structure.heading_lines.end())
      texts.push_back(sample.line(i));
  }
  return texts;
}

TableLayout proposed_table(ByteSource& source, const StructureResult& found, Findings& findings,
                           const TableTest& test) {
  const Proposal proposal = propose(source, chosen_block(source, *found.structure, test));
  if (used_columns(proposal) < kMinUsedColumns) nothing_fits(source, found, {});
  TableLayout layout = layout_of(proposal, source.name(), findings);
  check_channels(layout);
  layout.heading_texts = heading_texts(read_sample(source), *found.structure);
  return layout;
}

TableLayout placed_table(ByteSource& source, const Dialect& dialect, Findings& findings,
                         const TableTest& test) {
  const TableSample sample = read_sample(source);
  const auto found = find_structure(sample);
  if (!found.structure) nothing_fits(source, found, dialect);
  const std::size_t block = chosen_block(source, *found.structure, test);
  TableLayout layout = layout_of(dialect, *found.structure, block, source.name(), findings);
  layout.heading_texts = heading_texts(sample, *found.structure);
  const TableColumns table = read_columns(sample, *found.structure, {});
  for (PlannedColumn& column : layout.columns)
    column.holds_words = column.role == ColumnRole::stage && column.cell < table.columns.size() &&
                         !table.columns[column.cell].sample.is_number;
  check_channels(layout);
  find_clocks(source, layout, findings);
  return layout;
}

/// The first heading comes again, as in tables side by side.
bool repeats_headings(std::string_view line, Separator separator) {
  const Cells cells = cells_of(heading_text(line), separator);
  return !cells.empty() && !cells.front().empty() &&
         std::ranges::find(cells.begin() + 1, cells.end(), cells.front()) != cells.end();
}

/// True if q and p' of the headings are t and s': the readings of tables with the same headings
/// decide it, or leave it open.
bool has_other_definitions(ByteSource& source) {
  try {
    const std::vector<Proposal> proposals = propose(source);
    return std::ranges::any_of(proposals.front().questions, [](const TableQuestion& question) {
      return question.about == TableQuestion::About::definitions;
    });
  } catch (const BadInput&) {
    return false;
  }
}

/// The heading line of the forced dialect, or of the shipped one that knows most of its headings.
std::optional<Candidate> best_heading_line(const Head& head, const std::optional<Dialect>& forced) {
  if (forced) return find_heading_line(*forced, head);
  std::optional<Candidate> best;
  for (const Dialect& dialect : shipped_dialects()) {
    const auto found = find_heading_line(dialect, head);
    if (found && (!best || found->known > best->known)) best = found;
  }
  return best;
}

/// A table that no dialect knows by its headings.
TableLayout unknown_table(ByteSource& source, const Head& head,
                          const std::optional<Dialect>& forced, Findings& findings,
                          const TableTest& test) {
  const auto found = find_structure(read_sample(source));
  if (forced || !found.structure) nothing_fits(source, found, forced);
  if (found.structure->blocks.size() <= 1)
    refuse_other_separator(source, head, found.structure->separator);
  return proposed_table(source, found, findings, test);
}

/// Finds the first row and takes the units of a units row.
std::vector<std::optional<std::string>> find_first_row(TableLayout& layout, const Head& head,
                                                       std::size_t heading_line, std::size_t& row) {
  const auto& lines = head.lines;
  row = heading_line + 1;
  const auto skip = [&] {
    while (row < lines.size() &&
           (trimmed(lines[row]).empty() || is_comment(layout.dialect, lines[row])))
      ++row;
  };
  layout.first_row_line = static_cast<std::int64_t>(row) + 1;
  layout.heading_texts.push_back(lines[heading_line]);
  skip();
  std::vector<std::optional<std::string>> units;
  if (row < lines.size()) units = units_row(lines[row], layout.heading_separator);
  if (!units.empty()) {
    layout.heading_texts.push_back(lines[row]);
    layout.first_row_line = static_cast<std::int64_t>(++row) + 1;
    skip();
  }
  if (row >= lines.size() && head.whole_file)
    throw BadInput(layout.file, layout.heading_line,
                   "headings without a row of readings; the record is empty");
  return units;
}

/// The table below a heading line that a dialect knows.
TableLayout known_table(ByteSource& source, const Head& head, const Candidate& known,
                        bool is_forced, Findings& findings) {
  TableLayout layout;
  layout.dialect = *known.dialect;
  layout.file = source.name();
  layout.heading_line = static_cast<std::int64_t>(known.line) + 1;
  layout.heading_separator = known.separator;
  const auto& lines = head.lines;
  layout.head.assign(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(known.line));
  std::size_t row = 0;
  const auto units = find_first_row(layout, head, known.line, row);
  if (is_forced && !layout.dialect.comment_is_toml) {
    if (const auto* const with_more = dynamic_cast<const HasLinesBeside*>(&source))
      layout.beside = with_more->lines_beside();
    take_labels(layout);
  }
  const auto unknown = plan_columns(layout, heading_text(lines[known.line]), units, findings);
  layout.separator = row_separator(layout, row < lines.size() ? lines[row] : std::string());
  layout.ignored = joined(unknown, "; ");
  check_channels(layout);
  find_clocks(source, layout, findings);
  return layout;
}

/// All but the order of the rows and the range of the test.
TableLayout whole_table(ByteSource& source, const std::optional<Dialect>& forced,
                        Findings& findings, const TableTest& test) {
  if (forced && forced->has_places()) return placed_table(source, *forced, findings, test);
  const Head head = read_head(source);
  const std::optional<Candidate> best = best_heading_line(head, forced);
  if (!best) return unknown_table(source, head, forced, findings, test);
  if (!forced && repeats_headings(head.lines[best->line], best->separator))
    if (const auto found = find_structure(read_sample(source));
        found.structure && found.structure->blocks.size() > 1)
      return proposed_table(source, found, findings, test);
  if (!forced && !best->dialect->own_headings && has_other_definitions(source))
    return proposed_table(source, find_structure(read_sample(source)), findings, test);
  return known_table(source, head, *best, forced.has_value(), findings);
}

}  // namespace

namespace {

bool is_heading(const TableLayout& layout, std::string_view line) {
  return std::ranges::find(layout.heading_texts, line) != layout.heading_texts.end();
}

/// Labels of a test below another one.
void take_lines_between(ByteSource& source, TableLayout& layout, const TableTest& test) {
  LineReader reader(source);
  std::vector<std::string> lines;
  std::string_view line;
  while (reader.next(line) && reader.line_number() < test.first_line) {
    const bool is_between = reader.line_number() > test.line_before;
    if (is_between && !is_heading(layout, line) && lines.size() < kMaxHead_lines)
      lines.emplace_back(line);
  }
  take_labels_between(layout, std::move(lines), test.line_before + 1);
}

void take_foot(ByteSource& source, TableLayout& layout, const TableTest& test) {
  LineReader reader(source);
  std::vector<std::string> lines;
  std::string_view line;
  while (lines.size() < kMaxHead_lines && reader.next(line)) {
    if (reader.line_number() <= test.last_line) continue;
    if (trimmed(line).empty() || is_heading(layout, line)) break;
    lines.emplace_back(line);
  }
  take_lines_below(layout, std::move(lines));
}

}  // namespace

TableLayout recognise_table(ByteSource& source, const std::optional<Dialect>& forced,
                            Findings& findings, const TableTest& test) {
  TableLayout layout = whole_table(source, forced, findings, test);
  layout.test = test.name;
  layout.first_row_line = std::max(layout.first_row_line, test.first_line);
  if (test.line_before > 0) take_lines_between(source, layout, test);
  if (test.last_line > 0) {
    layout.last_row_line = test.last_line;
    take_foot(source, layout, test);
  }
  find_reversed_rows(source, layout, findings);
  return layout;
}

}  // namespace triax::lab

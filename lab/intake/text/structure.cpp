// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/structure.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/intake/text/heading_rows.hpp"
#include "lab/intake/text/row_model.hpp"

namespace triax::lab {
namespace {

/// In the order in which they are preferred if they explain a text equally well.
constexpr std::array kSeparators{Separator::tab,   Separator::semicolon,   Separator::pipe,
                                 Separator::comma, Separator::wide_blanks, Separator::blanks};

struct Candidate {
  RowModel rows;
  HeadingRows headings;
  double score = 0;
};

/// How well a separator explains the text: lines that are rows, cells that are values, columns that
/// have a name.
double score_of(const Candidate& one, std::size_t rank) {
  constexpr double kOfHeadings = 0.3;
  constexpr double kPerRank = 0.01;
  constexpr double kWithThousands = 0.95;
  const double rows =
      one.rows.coverage * one.rows.purity * (one.rows.format.thousands != 0 ? kWithThousands : 1);
  return rows * (1 + kOfHeadings * one.headings.coverage) - kPerRank * static_cast<double>(rank);
}

/// True if the headings have tabs, and most rows: these separate, and not the spaces.
bool has_tabs(const TableSample& sample, const Candidate& one) {
  const auto has_tab = [&](std::size_t i) {
    return sample.line(i).find('\t') != std::string::npos;
  };
  if (!std::ranges::all_of(one.headings.lines, has_tab)) return false;
  std::size_t tabs = 0, all = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (one.rows.is_row[i] == 0) continue;
    ++all;
    tabs += has_tab(i) ? 1 : 0;
  }
  return 2 * tabs > all;
}

/// The cells above a column, joined. The name of a group is written once, above its first column.
std::vector<std::string> joined_headings(const HeadingRows& headings, std::size_t from,
                                         std::size_t width) {
  std::vector<std::string> out(width);
  for (std::size_t line = from; line < headings.cells.size(); ++line) {
    std::string group;
    for (std::size_t column = 0; column < width; ++column) {
      const std::string& cell = headings.cells[line][column];
      if (!cell.empty()) group = cell;
      const bool is_group = line + 1 < headings.cells.size();
      const bool has_below = std::any_of(
          headings.cells.begin() + static_cast<std::ptrdiff_t>(line) + 1, headings.cells.end(),
          [&](const auto& below) { return !below[column].empty(); });
      const std::string& text = is_group && cell.empty() && has_below ? group : cell;
      out[column] = joined({out[column], text}, " ");
    }
  }
  return out;
}

std::string name_of(std::string_view heading) { return folded(heading); }

/// Tables side by side: the names of the first one come again, at equal distances or behind an
/// empty column.
std::vector<TableBlock> find_blocks(const RowModel& rows, const std::vector<std::string>& names) {
  std::vector<TableBlock> blocks;
  if (names.empty()) return blocks;
  std::vector<std::size_t> starts;
  for (std::size_t column = 0; column < names.size(); ++column)
    if (name_of(names[column]) == name_of(names.front()) && !names[column].empty())
      starts.push_back(column);
  if (starts.size() < 2) return blocks;
  starts.push_back(names.size());
  std::set<std::vector<std::string>> kinds;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    TableBlock block{.first_cell = starts[i], .cell_count = starts[i + 1] - starts[i], .title = {}};
    while (block.cell_count > 1 && names[block.first_cell + block.cell_count - 1].empty() &&
           !rows.is_used(block.first_cell + block.cell_count - 1))
      --block.cell_count;
    std::vector<std::string> kind;
    for (std::size_t k = 0; k < block.cell_count; ++k)
      kind.push_back(name_of(names[block.first_cell + k]));
    kinds.insert(kind);
    blocks.push_back(block);
  }
  const bool apart = std::ranges::all_of(starts, [&](std::size_t start) {
    return start == 0 || start == names.size() || !rows.is_used(start - 1);
  });
  const bool narrow =
      std::ranges::any_of(blocks, [](const TableBlock& b) { return b.cell_count < 2; });
  if (narrow || (kinds.size() > 1 && !apart)) return {};
  return blocks;
}

/// The comment mark that most lines outside the rows have.
std::string find_comment(const TableSample& sample, const RowModel& rows) {
  std::map<std::string_view, std::size_t> counts;
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (rows.is_row[i] == 0)
      if (const auto mark = comment_mark(sample.line(i), rows.separator); !mark.empty())
        ++counts[mark];
  const auto most =
      std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; });
  return most == counts.end() ? std::string() : std::string(most->first);
}

void take_lines(TableStructure& table, const TableSample& sample, const RowModel& rows,
                const HeadingRows& headings) {
  for (const auto line : headings.lines) table.heading_lines.push_back(sample.number(line));
  if (headings.unit_line) table.unit_line = sample.number(*headings.unit_line);
  table.first_row_line = sample.number(rows.first);
  bool is_end = true;
  for (std::size_t i = rows.last + 1; i < sample.size(); ++i)
    is_end = is_end && rows.lines[i].is_blank();
  if (!is_end && (sample.whole || rows.last >= sample.first.size()))
    table.last_row_line = sample.number(rows.last);
  const auto is_heading = [&](std::size_t i) {
    const auto is_same = [&](std::size_t line) { return sample.line(line) == sample.line(i); };
    return std::ranges::any_of(headings.lines, is_same) ||
           (headings.unit_line && is_same(*headings.unit_line));
  };
  for (std::size_t i = rows.first; i < rows.last; ++i)
    if (rows.is_row[i] == 0 && !rows.lines[i].is_blank() &&
        (!rows.lines[i].is_comment || is_heading(i)))
      table.repeated_heading_lines.push_back(sample.number(i));
  const auto top = headings.lines.empty() ? rows.first : headings.top;
  for (std::size_t i = 0; i < top; ++i) table.preamble.push_back(sample.line(i));
}

/// From the rows, the headings and the units.
CellExtents find_extents(const TableSample& sample, const RowModel& rows,
                         const HeadingRows& headings) {
  if (character(rows.separator) != 0) return {};
  CellExtents out(rows.width);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const bool is_heading = std::ranges::find(headings.lines, i) != headings.lines.end();
    if (rows.is_row[i] != 0 || is_heading || headings.unit_line == i)
      out.add(sample.line(i), cells_of(sample.line(i), rows.separator));
  }
  return out;
}

TableStructure describe(const TableSample& sample, const Candidate& best) {
  const RowModel& rows = best.rows;
  TableStructure table;
  table.separator = rows.separator;
  table.decimal = rows.format.decimal;
  table.thousands = rows.format.thousands;
  table.column_count = rows.width;
  table.extents = find_extents(sample, rows, best.headings);
  table.comment = find_comment(sample, rows);
  table.beside = sample.beside;
  take_lines(table, sample, rows, best.headings);
  table.units = best.headings.units;
  const auto& lines = best.headings.cells;
  if (!lines.empty()) table.blocks = find_blocks(rows, lines.back());
  std::size_t titles = 0;
  if (!table.blocks.empty() && lines.size() > 1) {
    titles = 1;
    for (TableBlock& block : table.blocks) block.title = lines.front()[block.first_cell];
  }
  table.headings = joined_headings(best.headings, titles, rows.width);
  if (lines.size() > 1 + titles) table.lowest_headings = lines.back();
  while (table.column_count > 1 && !rows.is_used(table.column_count - 1) &&
         table.headings[table.column_count - 1].empty())
    table.headings.resize(--table.column_count);
  if (!table.units.empty()) table.units.resize(table.column_count);
  return table;
}

std::string reason_of(const TableSample& sample, const std::vector<Candidate>& candidates) {
  const bool is_empty = std::ranges::any_of(candidates, [](const Candidate& one) {
    return std::ranges::all_of(one.rows.lines, &ShapedLine::is_blank);
  });
  if (is_empty) return "the file is empty";
  const auto singles = std::ranges::max(candidates, {}, [](const Candidate& one) {
                         return one.rows.single_values;
                       }).rows.single_values;
  return 2 * singles > sample.size() ? "one column" : "only text";
}

}  // namespace

StructureResult find_structure(const TableSample& sample) {
  std::vector<Candidate> candidates;
  for (std::size_t rank = 0; rank < kSeparators.size(); ++rank) {
    Candidate one{.rows = fit_rows(sample, kSeparators[rank]), .headings = {}, .score = -1};
    if (one.rows.width > 1) {
      one.headings = find_heading_rows(sample, one.rows);
      one.score = score_of(one, rank);
      constexpr double kWithTabs = 0.7;
      const bool is_blanks = character(one.rows.separator) == 0;
      if (is_blanks && has_tabs(sample, one)) one.score *= kWithTabs;
    }
    candidates.push_back(std::move(one));
  }
  const auto best = std::ranges::max_element(candidates, {}, &Candidate::score);
  if (best->rows.width < 2) return {std::nullopt, reason_of(sample, candidates)};
  StructureResult result{describe(sample, *best), {}};
  if (result.structure->heading_lines.empty())
    result.reason = fmt::format("{} columns of numbers and no heading", best->rows.width);
  return result;
}

}  // namespace triax::lab

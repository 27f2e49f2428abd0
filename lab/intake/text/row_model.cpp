// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/row_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

/// Kinds of cells by which rows differ from other text.
enum CellKindInRow { kValueCell, kEmptyCell, kTextCell };

CellKindInRow kind_of(CellShape shape) {
  if (is_value(shape)) return kValueCell;
  return shape == CellShape::empty ? kEmptyCell : kTextCell;
}

std::string_view without_quote(std::string_view text) {
  return text.starts_with('"') ? text.substr(1) : text;
}

ShapedLine shaped(std::string_view line, Separator separator) {
  ShapedLine out;
  const auto cells = cells_of(line, separator);
  for (const auto cell : cells) out.cells.push_back(find_shape(cell));
  out.cell_count = cells.size();
  while (!out.cells.empty() && out.cells.back().shape == CellShape::empty) out.cells.pop_back();
  for (const ShapedCell& cell : out.cells) {
    out.values += is_value(cell.shape) ? 1 : 0;
    out.numbers += is_value(cell.shape) && cell.shape != CellShape::fill ? 1 : 0;
    out.texts += cell.shape == CellShape::text ? 1 : 0;
  }
  const std::string_view text = without_quote(trimmed(line));
  out.is_comment = !comment_mark(line, separator).empty() &&
                   (cells.empty() || find_shape(cells.front()).shape != CellShape::fill ||
                    !text.starts_with(cells.front()));
  return out;
}

bool same_kinds(const ShapedLine& a, const ShapedLine& b) {
  return std::ranges::equal(
      a.cells, b.cells, {}, [](const ShapedCell& cell) { return kind_of(cell.shape); },
      [](const ShapedCell& cell) { return kind_of(cell.shape); });
}

/// Lines that are rows whatever the columns are: most cells are values, or the line beside it has
/// the same kinds of cells.
std::vector<std::size_t> find_likely_rows(const std::vector<ShapedLine>& lines) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ShapedLine& line = lines[i];
    if (line.is_comment || line.values < 2 || line.numbers == 0) continue;
    const bool repeated = (i > 0 && same_kinds(line, lines[i - 1])) ||
                          (i + 1 < lines.size() && same_kinds(line, lines[i + 1]));
    if (line.values > line.texts || repeated) rows.push_back(i);
  }
  return rows;
}

/// The number of cells that most of the rows have, or more if a tenth of them fills more.
std::size_t find_width(const std::vector<ShapedLine>& lines, const std::vector<std::size_t>& rows) {
  std::map<std::size_t, std::size_t> counts;
  std::map<std::size_t, std::size_t> filled;
  for (const auto i : rows) {
    ++counts[lines[i].cell_count];
    ++filled[lines[i].cells.size()];
  }
  std::size_t width = 0;
  std::size_t most = 0;
  for (const auto& [cells, count] : counts)
    if (count * cells > most) {
      most = count * cells;
      width = cells;
    }
  for (const auto& [cells, count] : filled)
    if (cells > width && 10 * count >= rows.size()) width = cells;
  return width;
}

void take_profile(RowModel& model, const std::vector<std::size_t>& rows) {
  model.profile.assign(model.width, {});
  for (const auto i : rows)
    for (std::size_t column = 0; column < model.width; ++column) {
      ColumnProfile& profile = model.profile[column];
      const auto kind = kind_of(model.lines[i].shape(column));
      (kind == kValueCell   ? profile.values
       : kind == kEmptyCell ? profile.empties
                            : profile.texts) += 1;
    }
}

/// Logarithm of the odds that the line is a row and not other text. One cell that does not fit
/// counts only so much against the others.
double log_odds(const RowModel& model, const ShapedLine& line) {
  constexpr std::array kOfOtherText{0.25, 0.35, 0.4};
  constexpr std::array kWorst{-1.0, -1.0, -3.0};
  constexpr double kUnseen = 0.1;
  double sum = 0;
  for (std::size_t column = 0; column < model.width; ++column) {
    const ColumnProfile& profile = model.profile[column];
    const std::array counts{profile.values, profile.empties, profile.texts};
    const auto kind = kind_of(line.shape(column));
    const double all = profile.values + profile.empties + profile.texts + 3 * kUnseen;
    const double odds = std::log((counts[kind] + kUnseen) / all / kOfOtherText[kind]);
    sum += std::max(odds, kWorst[kind]);
  }
  for (std::size_t column = model.width; column < line.cells.size(); ++column)
    sum += line.cells[column].shape == CellShape::empty ? 0 : kWorst[kTextCell];
  return sum;
}

std::vector<std::size_t> find_rows(const RowModel& model) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < model.lines.size(); ++i) {
    const ShapedLine& line = model.lines[i];
    const bool has_no_text = line.texts == 0 && line.cell_count == model.width;
    if (!line.is_comment && line.numbers > 0 && (has_no_text || log_odds(model, line) > 0))
      rows.push_back(i);
  }
  return rows;
}

/// A heading that looks like a row, because most of its cells are numbers: text in a column of
/// values.
bool begins_no_run(const RowModel& model, const ShapedLine& line) {
  for (std::size_t column = 0; column < model.width; ++column)
    if (line.shape(column) == CellShape::text && model.is_value_column(column)) return true;
  return false;
}

/// Texts of a column with other cells that are only in a few rows at the end: names of a summary
/// below dates that are written once a day, or below empty cells.
bool has_texts_only_at_end(const RowModel& model, std::size_t row, std::size_t column) {
  constexpr double kMaxTexts = 6;
  const ColumnProfile& profile = model.profile[column];
  if (profile.values + profile.empties == 0 || profile.texts > kMaxTexts) return false;
  std::size_t count = 0, texts = 0;
  for (std::size_t i = 0; i < model.lines.size(); ++i)
    texts += model.is_row[i] != 0 && model.lines[i].shape(column) == CellShape::text ? 1 : 0;
  for (std::size_t i = row + 1; i-- > 0;) {
    if (model.is_row[i] == 0) continue;
    if (model.lines[i].shape(column) != CellShape::text) break;
    ++count;
  }
  return count == texts;
}

/// A summary that looks like a row: a label, then values ("Max;12.3;200"). Where rows begin with
/// text, too ("Shear;12.3;200"), a text that comes once among others that are repeated.
bool ends_no_run(const RowModel& model, const TableSample& sample, std::size_t row) {
  constexpr double kMinTexts = 0.2;  // of a column whose cells are texts
  const ShapedLine& line = model.lines[row];
  std::size_t column = 0;
  while (column < model.width && line.shape(column) == CellShape::empty) ++column;
  if (column == model.width) return true;
  if (line.shape(column) != CellShape::text) return false;
  const ColumnProfile& profile = model.profile[column];
  const double all = profile.values + profile.empties + profile.texts;
  if (model.is_value_column(column) || profile.texts < kMinTexts * all) return true;
  if (has_texts_only_at_end(model, row, column)) return true;
  std::map<std::string_view, std::size_t> counts;
  for (std::size_t i = 0; i < model.lines.size(); ++i)
    if (model.is_row[i] != 0 && model.lines[i].shape(column) == CellShape::text)
      ++counts[cells_of(sample.line(i), model.separator)[column]];
  const auto once = std::ranges::count_if(counts, [](const auto& one) { return one.second == 1; });
  return counts[cells_of(sample.line(row), model.separator)[column]] == 1 &&
         4 * static_cast<double>(once) < profile.texts;
}

struct Run {
  std::size_t first = 0, last = 0, rows = 0;
  double odds = 0;
};

/// Rows with no other text between them than blank lines and comments.
std::vector<Run> find_runs(const RowModel& model) {
  std::vector<Run> runs;
  bool is_open = false;
  for (std::size_t i = 0; i < model.lines.size(); ++i) {
    if (model.is_row[i] == 0) {
      is_open = is_open && (model.lines[i].is_blank() || model.lines[i].is_comment);
      continue;
    }
    if (!is_open) runs.push_back({.first = i});
    is_open = true;
    runs.back().last = i;
    ++runs.back().rows;
    runs.back().odds += log_odds(model, model.lines[i]);
  }
  return runs;
}

std::ptrdiff_t at(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

/// Takes away a few rows behind a blank line at the end of a run, if one of them is a summary.
void trim_summary(RowModel& model, const TableSample& sample, const Run& run) {
  constexpr std::size_t kMaxRows = 4;
  std::size_t first = run.last;
  while (first > run.first && model.is_row[first - 1] != 0) --first;
  if (first == run.first || run.last - first >= kMaxRows) return;
  for (std::size_t i = first; i <= run.last; ++i)
    if (ends_no_run(model, sample, i)) {
      std::fill(model.is_row.begin() + at(first), model.is_row.begin() + at(run.last + 1), 0);
      return;
    }
}

/// A line of a summary that has the name of a stage: two others are directly above it.
bool follows_summary(const RowModel& model, const TableSample& sample, const Run& run,
                     std::size_t row) {
  return row >= run.first + 2 && model.is_row[row - 1] != 0 && model.is_row[row - 2] != 0 &&
         ends_no_run(model, sample, row - 1) && ends_no_run(model, sample, row - 2);
}

/// Takes away what looks like a row at the ends of runs, and runs of one row above the largest.
void trim_runs(RowModel& model, const TableSample& sample) {
  const auto is_row = [&](std::size_t i) { return model.is_row[i] != 0; };
  for (const Run& run : find_runs(model)) {
    std::size_t i = run.first;
    for (; i < run.last; ++i)
      if (is_row(i) && !begins_no_run(model, model.lines[i]) &&
          !is_numbering(sample.line(i), model.separator))
        break;
    if (i == run.last && begins_no_run(model, model.lines[i])) ++i;
    std::fill(model.is_row.begin() + at(run.first), model.is_row.begin() + at(i), 0);
    trim_summary(model, sample, run);
    i = run.last;
    while (i > run.first && !is_row(i)) --i;
    while (is_row(i) && (ends_no_run(model, sample, i) || follows_summary(model, sample, run, i))) {
      model.is_row[i] = 0;
      while (i > run.first && !is_row(i)) --i;
    }
  }
  const auto runs = find_runs(model);
  if (runs.empty()) return;
  const auto largest = std::ranges::max_element(runs, {}, &Run::odds);
  for (auto run = runs.begin(); run != largest; ++run)
    if (run->rows == 1) model.is_row[run->first] = 0;
}

/// A row in which many values are missing, directly above the others: no column of values has
/// text. Between spaces an empty cell is none.
bool is_sparse_row(const RowModel& model, const ShapedLine& line) {
  if (line.is_comment || line.numbers == 0) return false;
  if (model.separator == Separator::blanks || model.separator == Separator::wide_blanks)
    return line.texts == 0;
  return line.cell_count == model.width && !begins_no_run(model, line);
}

void add_sparse_rows(RowModel& model, const TableSample& sample) {
  auto first = static_cast<std::size_t>(std::ranges::find(model.is_row, 1) - model.is_row.begin());
  while (first > 0 && first < model.lines.size() && is_sparse_row(model, model.lines[first - 1]) &&
         !is_numbering(sample.line(first - 1), model.separator))
    model.is_row[--first] = 1;
}

/// The format in which most numbers can be read, and what fraction of all cells that is.
void choose_format(RowModel& model) {
  std::array<std::size_t, kNumberFormats.size()> counts{};
  std::size_t numbers = 0;
  std::size_t values = 0;
  std::size_t cells = 0;
  for (std::size_t i = 0; i < model.lines.size(); ++i) {
    if (model.is_row[i] == 0) continue;
    for (const ShapedCell& cell : model.lines[i].cells) {
      cells += cell.shape == CellShape::empty ? 0 : 1;
      values += is_value(cell.shape) ? 1 : 0;
      numbers += cell.shape == CellShape::number ? 1 : 0;
      for (std::size_t format = 0; format < counts.size(); ++format)
        counts[format] += (cell.formats >> format) & 1U;
    }
  }
  const auto* const best = std::ranges::max_element(counts);
  model.format = kNumberFormats[static_cast<std::size_t>(best - counts.data())];
  const auto matched = static_cast<double>(values - numbers + *best);
  model.purity = cells > 0 ? matched / static_cast<double>(cells) : 0;
}

}  // namespace

std::string_view comment_mark(std::string_view line, Separator separator) {
  constexpr std::array<std::string_view, 8> kMarks{"//", "**", "#", "%", "!", ";", "*", "'"};
  line = trimmed(line);
  const bool is_quoted = line.starts_with('"');
  line = without_quote(line);
  for (const auto mark : kMarks) {
    if (!line.starts_with(mark) || mark.front() == character(separator)) continue;
    char next = mark.size() < line.size() ? line[mark.size()] : ' ';
    if (is_quoted && next == '"') next = character(separator);
    const bool is_name = next == character(separator) && mark != "%";
    const bool is_text = is_name || next == ' ' || next == '(' || next == '[' ||
                         static_cast<unsigned char>(next) >= 0x80 || (next >= '0' && next <= '9') ||
                         (next >= 'A' && next <= 'Z') || (next >= 'a' && next <= 'z');
    if (is_text) return mark;
  }
  return {};
}

std::vector<std::string_view> cells_of(std::string_view line, Separator separator) {
  std::vector<std::string_view> cells;
  split_cells(line, separator, cells);
  if (cells.size() > kMaxCells) cells.resize(kMaxCells);
  return cells;
}

bool is_numbering(std::string_view line, Separator separator) {
  constexpr std::size_t kMinColumns = 4;
  const auto cells = cells_of(line, separator);
  std::size_t number = 0;
  return cells.size() >= kMinColumns && std::ranges::all_of(cells, [&](std::string_view cell) {
           if (cell.starts_with('(') && cell.ends_with(')')) cell = cell.substr(1, cell.size() - 2);
           return cell == fmt::format_int(++number).str();
         });
}

RowModel fit_rows(const TableSample& sample, Separator separator) {
  RowModel model;
  model.separator = separator;
  std::size_t texts = 0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    model.lines.push_back(shaped(sample.line(i), separator));
    const ShapedLine& line = model.lines.back();
    texts += line.is_blank() || line.is_comment ? 0 : 1;
    model.single_values += line.cells.size() == 1 && line.numbers == 1 ? 1 : 0;
  }
  auto rows = find_likely_rows(model.lines);
  if (rows.empty()) return model;
  model.width = find_width(model.lines, rows);
  take_profile(model, rows);
  rows = find_rows(model);
  take_profile(model, rows);
  model.is_row.assign(model.lines.size(), 0);
  for (const auto i : find_rows(model)) model.is_row[i] = 1;
  trim_runs(model, sample);
  add_sparse_rows(model, sample);
  const auto first = std::ranges::find(model.is_row, 1);
  if (first == model.is_row.end()) {
    model.width = 0;
    return model;
  }
  model.first = static_cast<std::size_t>(first - model.is_row.begin());
  model.last = model.is_row.size() - 1;
  while (model.is_row[model.last] == 0) --model.last;
  choose_format(model);
  model.coverage = static_cast<double>(std::ranges::count(model.is_row, 1)) /
                   static_cast<double>(std::max<std::size_t>(texts, 1));
  return model;
}

}  // namespace triax::lab

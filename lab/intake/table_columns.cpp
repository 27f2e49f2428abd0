// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/table_columns.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "lab/base/text.hpp"
#include "lab/intake/cells/fill_values.hpp"
#include "lab/intake/text/number_cell.hpp"
#include "lab/intake/text/row_model.hpp"
#include "lab/records/cells/printed_value.hpp"

namespace triax::lab {
namespace {

using Cells = std::vector<std::string_view>;

/// The cells of the rows of a sample.
struct Rows {
  std::vector<std::int64_t> lines;
  std::vector<Cells> cells;
};

bool is_row(const TableStructure& structure, std::int64_t line, std::string_view text) {
  if (line < structure.first_row_line) return false;
  if (structure.last_row_line > 0 && line > structure.last_row_line) return false;
  if (std::ranges::binary_search(structure.repeated_heading_lines, line)) return false;
  return !begins_with_comment(text, structure.comment);
}

Rows rows_of(const TableSample& sample, const TableStructure& structure) {
  Rows rows;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const std::string& line = sample.line(i);
    if (!is_row(structure, sample.number(i), line)) continue;
    Cells cells;
    split_cells(line, structure.separator, cells);
    if (std::ranges::all_of(cells, &std::string_view::empty)) continue;
    if (cells.size() < structure.column_count) structure.extents.place(line, cells);
    rows.lines.push_back(sample.number(i));
    rows.cells.push_back(std::move(cells));
  }
  return rows;
}

/// A column of the rows as numbers.
struct Numbers {
  std::vector<double> values;
  double half_unit = HUGE_VAL;
  std::size_t numbers = 0, texts = 0;
  std::vector<std::size_t> missing;  ///< rows
};

std::string_view cell_of(const Cells& cells, std::size_t cell) {
  return cell < cells.size() ? cells[cell] : std::string_view();
}

/// A code for "no value", unless it is between the values of the rows beside it, a negative one
/// with as many digits as the value before: a time of 9999 s, a stress of -999.0 kPa.
bool is_code(const Rows& rows, std::size_t row, std::size_t cell, NumberFormat format, double value,
             std::string_view before_text, double before) {
  if (!means_no_value(value, before)) return false;
  double after = kMissing;
  if (row + 1 < rows.cells.size())
    parse_number_cell(cell_of(rows.cells[row + 1], cell), format, after);
  const bool is_between = (before < value && value < after) || (before > value && value > after);
  const std::string_view text = cell_of(rows.cells[row], cell);
  return !is_between || (value < 0 && half_unit_of(text) != half_unit_of(before_text));
}

Numbers numbers_of(const Rows& rows, std::size_t cell, const TableStructure& structure) {
  Numbers out;
  double before = kMissing;
  std::string_view before_text;
  const NumberFormat format{structure.decimal, structure.thousands};
  for (std::size_t row = 0; row < rows.cells.size(); ++row) {
    const std::string_view text = cell_of(rows.cells[row], cell);
    double value = kMissing;
    const CellKind kind = parse_number_cell(text, format, value);
    const bool is_number =
        kind == CellKind::number && !is_code(rows, row, cell, format, value, before_text, before);
    if (is_number) {
      ++out.numbers;
      out.half_unit = std::min(out.half_unit, half_unit_of(text));
      before = value;
      before_text = text;
    } else if (kind == CellKind::text) {
      ++out.texts;
    } else {
      out.missing.push_back(row);
    }
    out.values.push_back(is_number ? value : kMissing);
  }
  if (!std::isfinite(out.half_unit)) out.half_unit = 0;
  return out;
}

/// By the best names of the heading.
ClockHeading clock_heading(const HeadingNames& names) {
  for (const NameCandidate& one : names.candidates) {
    if (one.how != names.candidates.front().how || one.quantity->name == "time") break;
    if (one.quantity->name == "date" || one.quantity->name == "clock") return ClockHeading::date;
    if (one.quantity->name == "time_of_day") return ClockHeading::time_of_day;
  }
  return ClockHeading::time;
}

/// True if the heading names another quantity than a time.
bool is_other(const HeadingNames& names) {
  if (names.candidates.empty()) return false;
  const NameCandidate& best = names.candidates.front();
  const auto& dimension = best.quantity->dimension;
  return best.how == NameMatch::exact && dimension != "time" && dimension != "clock";
}

std::optional<ClockFinding> clock_of(const Rows& rows, std::size_t cell, const Numbers& numbers,
                                     const HeadingNames& names, bool has_unit) {
  const bool only_numbers = numbers.texts == 0;
  if (only_numbers && clock_heading(names) == ClockHeading::time && (has_unit || is_other(names)))
    return std::nullopt;
  Cells cells;
  for (const Cells& row : rows.cells) cells.push_back(cell < row.size() ? row[cell] : "");
  ClockFinding found = find_clock_format(
      cells, only_numbers ? clock_heading(names)
                          : std::min(clock_heading(names), ClockHeading::time_of_day));
  if (!found.format) return std::nullopt;
  return found;
}

/// The whole heading, and its lowest line if there are several.
std::vector<std::string> heading_parts(const TableStructure& structure, std::size_t cell) {
  std::vector<std::string> parts{cell < structure.headings.size() ? structure.headings[cell] : ""};
  const auto& lowest = structure.lowest_headings;
  if (cell < lowest.size() && !lowest[cell].empty()) parts.push_back(lowest[cell]);
  return parts;
}

}  // namespace

std::vector<double> evenly(std::span<const double> values) {
  if (values.size() <= kMeaningRows) return {values.begin(), values.end()};
  std::vector<double> out;
  for (std::size_t i = 0; i < kMeaningRows; ++i)
    out.push_back(values[i * (values.size() - 1) / (kMeaningRows - 1)]);
  return out;
}

namespace {

TableColumn column_of(const TableStructure& structure, const Rows& rows, std::size_t cell,
                      const Numbers& numbers) {
  TableColumn column;
  column.position = cell + 1;
  column.sample.headings = heading_parts(structure, cell);
  column.heading = column.sample.headings.front();
  if (cell < structure.units.size()) column.sample.unit_of_row = structure.units[cell];
  column.sample.half_unit = numbers.half_unit;
  column.sample.values = evenly(numbers.values);
  column.all = numbers.values;
  column.sample.is_number = numbers.numbers > numbers.texts && numbers.numbers > 0;
  HeadingNames names;
  for (const std::string& heading : column.sample.headings)
    if (names.candidates.empty()) names = find_names(heading, column.sample.unit_of_row);
  column.title = find_names(column.heading, column.sample.unit_of_row).name;
  std::ranges::replace(column.title, '_', ' ');
  const bool has_unit = !names.unit.empty() || !column.sample.unit_of_row.empty();
  column.clock = clock_of(rows, cell, numbers, names, has_unit);
  if (column.clock) column.sample.is_number = false;
  if (column.clock)
    for (const Cells& row : rows.cells)
      column.clock_values.push_back(
          cell < row.size() ? clock_seconds(*column.clock->format, row[cell]).value_or(kMissing)
                            : kMissing);
  const auto cell_of_row = [&](const Cells& cells) { return std::string(cell_of(cells, cell)); };
  if (!column.clock && !column.sample.is_number)
    for (const Cells& row : rows.cells) column.texts.push_back(cell_of_row(row));
  if (!rows.cells.empty()) {
    column.first_cell = cell_of_row(rows.cells.front());
    for (auto row = rows.cells.rbegin(); row != rows.cells.rend() && column.last_cell.empty();
         ++row)
      column.last_cell = cell_of_row(*row);
  }
  return column;
}

/// The first row without a missing number.
std::size_t first_complete(const std::vector<Numbers>& columns, std::size_t rows) {
  for (std::size_t row = 0; row < rows; ++row)
    if (std::ranges::none_of(columns, [row](const Numbers& one) {
          return one.numbers > one.texts && std::isnan(one.values[row]);
        }))
      return row;
  return 0;
}

}  // namespace

TableColumns read_columns(const TableSample& sample, const TableStructure& structure,
                          const TableBlock& block) {
  TableColumns out;
  const Rows rows = rows_of(sample, structure);
  out.row_lines = rows.lines;
  const std::size_t end = block.cell_count > 0
                              ? block.first_cell + block.cell_count
                              : std::max(structure.column_count, structure.headings.size());
  std::vector<Numbers> numbers;
  for (std::size_t cell = block.first_cell; cell < end; ++cell)
    numbers.push_back(numbers_of(rows, cell, structure));
  const std::size_t complete = first_complete(numbers, rows.cells.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    TableColumn column = column_of(structure, rows, block.first_cell + i, numbers[i]);
    if (!rows.cells.empty()) {
      column.first = numbers[i].values[complete];
      column.last = numbers[i].values.back();
      for (std::size_t row = complete + 1; column.clock && row-- > 0;) {
        const Cells& cells = rows.cells[row];
        if (block.first_cell + i >= cells.size() || cells[block.first_cell + i].empty()) continue;
        column.first_cell = cells[block.first_cell + i];
        break;
      }
    }
    if (column.sample.is_number)
      for (const std::size_t row : numbers[i].missing)
        out.missing.emplace_back(rows.lines[row], column.position);
    out.columns.push_back(std::move(column));
  }
  return out;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/clock_columns.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/line_reader.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/cells/fill_values.hpp"

namespace triax::lab {
namespace {

bool may_hold_clock(const PlannedColumn& column) {
  return column.role != ColumnRole::quantity && column.role != ColumnRole::stage &&
         column.role != ColumnRole::test;
}

bool is_part_of_clock(const PlannedColumn& column) {
  return column.role == ColumnRole::date || column.role == ColumnRole::time_of_day;
}

/// Cells of some columns, from rows at both ends of a table.
class ClockCells {
 public:
  ClockCells(ByteSource& source, const TableLayout& layout) : layout_(layout), lines_(source) {
    for (const PlannedColumn& column : layout.columns)
      if (may_hold_clock(column)) places_.push_back(column.cell);
    cells_.resize(places_.size());
    std::string_view line;
    while (lines_.line_number() + 1 < layout.first_row_line && lines_.next(line)) continue;
  }

  void take_first() {
    std::string_view line;
    for (std::size_t rows = 0; rows < kClockRows && next(line);) rows += take(line);
  }
  void take_last() {
    std::vector<std::string> kept(kClockRows);
    std::size_t count = 0;
    std::string_view line;
    while (next(line))
      if (line.size() <= kMaxKeptSize) kept[count++ % kClockRows] = line;
    for (std::size_t i = count - std::min(count, kClockRows); i < count; ++i)
      take(kept[i % kClockRows]);
  }

  std::vector<std::string_view> of(std::size_t column) const {
    const auto at = std::ranges::find(places_, column) - places_.begin();
    const auto& cells = cells_[static_cast<std::size_t>(at)];
    return {cells.begin(), cells.end()};
  }

 private:
  static constexpr std::size_t kMaxKeptSize = std::size_t{1} << 14, kMaxCellSize = 80;

  /// Up to the last line of the rows. A line that is no text ends the sample; the reader of the
  /// rows reports it.
  bool next(std::string_view& line) {
    if (layout_.last_row_line > 0 && lines_.line_number() >= layout_.last_row_line) return false;
    try {
      return lines_.next(line);
    } catch (const BadInput&) {
      return false;
    }
  }

  bool take(std::string_view line) {
    if (begins_with_comment(line, layout_.dialect.comment)) return false;
    split_cells(line, layout_.separator, row_);
    if (row_.size() < layout_.cell_count) return false;
    for (std::size_t i = 0; i < places_.size(); ++i)
      cells_[i].emplace_back(row_[places_[i]].substr(0, kMaxCellSize));
    return true;
  }

  const TableLayout& layout_;
  LineReader lines_;
  std::vector<std::size_t> places_;
  std::vector<std::vector<std::string>> cells_;
  std::vector<std::string_view> row_;
};

ClockFinding find_clock(const PlannedColumn& column, const ClockCells& cells) {
  const auto heading = column.role == ColumnRole::date          ? ClockHeading::date
                       : column.role == ColumnRole::time_of_day ? ClockHeading::time_of_day
                                                                : ClockHeading::time;
  return find_clock_format(cells.of(column.cell), heading, column.date_order);
}

/// False if rows further down can decide: the order of a date, or hours beyond 24.
bool is_decided(const ClockFinding& found) {
  return !found.format || (found.format->order != DateOrder::none && !found.is_ambiguous);
}

void check_no_clock(const TableLayout& layout, const PlannedColumn& column,
                    const ClockCells& cells) {
  if (!is_part_of_clock(column) && !column.date_order) {
    if (!column.unit_fault.empty()) throw BadInput(column.unit_fault);
    return;
  }
  for (const auto cell : cells.of(column.cell))
    if (!is_fill_text(cell))
      throw BadInput(
          layout.file, layout.first_row_line,
          fmt::format("column {} has {}, which is not a {}{}", excerpt(column.heading),
                      excerpt(cell),
                      column.role == ColumnRole::time_of_day ? "time of day" : "date",
                      column.date_order ? fmt::format(" with the {}", name(*column.date_order))
                                        : std::string()));
}

void note_clock(const TableLayout& layout, const PlannedColumn& column, const ClockFinding& found,
                Findings& findings) {
  std::string assumed;
  if (found.is_ambiguous && found.format->order != DateOrder::none)
    assumed = fmt::format("; {} is assumed: if that is wrong, give date_order in a dialect",
                          name(found.format->order));
  else if (found.is_ambiguous)
    assumed = "; hours:minutes are assumed";
  findings.note("clock " + column.heading, layout.heading_line,
                fmt::format("column {} is a clock, counted from the first reading; {}{}",
                            excerpt(column.heading), found.evidence, assumed));
}

}  // namespace

void find_clocks(ByteSource& source, TableLayout& layout, Findings& findings) {
  if (std::ranges::none_of(layout.columns, may_hold_clock)) return;
  ClockCells cells(source, layout);
  cells.take_first();
  const bool decided = std::ranges::all_of(layout.columns, [&](const PlannedColumn& column) {
    return !may_hold_clock(column) || is_decided(find_clock(column, cells));
  });
  if (!decided) cells.take_last();
  const auto is_number = [&](const PlannedColumn& column) {
    return column.role == ColumnRole::time && !find_clock(column, cells).format;
  };
  if (std::ranges::any_of(layout.columns, is_number))
    std::erase_if(layout.columns, is_part_of_clock);
  for (PlannedColumn& column : layout.columns) {
    if (!may_hold_clock(column)) continue;
    const auto found = find_clock(column, cells);
    const bool is_dated = found.format && found.format->order != DateOrder::none;
    if (found.format && !(is_dated && column.role == ColumnRole::stage_time)) {
      column.clock = found.format;
      note_clock(layout, column, found, findings);
    } else {
      check_no_clock(layout, column, cells);
    }
  }
  std::erase_if(layout.columns, [](const PlannedColumn& column) {
    return is_part_of_clock(column) && !column.clock;  // no cell has a value
  });
}

}  // namespace triax::lab

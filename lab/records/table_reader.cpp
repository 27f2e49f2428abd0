// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/table_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/records/cells/no_value.hpp"

namespace triax::lab {
namespace {

std::size_t slot_of(const PlannedColumn& column, std::size_t time, std::size_t stage_time,
                    std::size_t stage) {
  switch (column.role) {
    case ColumnRole::time:
      return time;
    case ColumnRole::stage_time:
      return stage_time;
    case ColumnRole::stage:
      return stage;
    case ColumnRole::quantity:
      break;
  }
  return index(column.quantity);
}

/// Nothing but the byte with which DOS ended its text files, as it is or as a spreadsheet writes
/// it.
bool is_end_mark(std::string_view line) {
  constexpr std::string_view kAround = " \t,;\"";
  const auto first = line.find_first_not_of(kAround);
  if (first == std::string_view::npos) return false;
  const auto last = line.find_last_not_of(kAround);
  const auto text = line.substr(first, last - first + 1);
  return text == "\x1A" || text == "_x001A_";
}

/// A number of more digits, or with an exponent, as spreadsheets and programs write doubles.
bool parse_long(const char*& at, const char* end, double& value) {
  const char* const digit = at != end && *at == '-' ? at + 1 : at;
  if (digit == end || static_cast<unsigned>(*digit - '0') > 9U) return false;
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error != std::errc{}) return false;
  at = stop;
  return true;
}

/// What no apparatus measures, in the quantity's unit; a stress that somebody reduced has the limit
/// of the pressures that it comes from.
double absurd_of(Quantity quantity) {
  const QuantityInfo& row = info(quantity);
  return row.unit == "kPa" ? info(Quantity::cell_pressure).raw.absurd : row.raw.absurd;
}

double limit_of(const PlannedColumn& column) {
  if (column.role != ColumnRole::quantity) return std::numeric_limits<double>::infinity();
  return sim::to_si(absurd_of(column.quantity), *sim::find_unit(info(column.quantity).unit));
}

}  // namespace

TableReader::TableReader(ByteSource& source, const TableLayout& layout, Findings& findings)
    : layout_(layout),
      findings_(findings),
      lines_(source),
      plan_(layout.cell_count),
      consistency_(layout),
      decimal_(layout.dialect.decimal),
      separator_(character(layout.separator)) {
  for (auto& row : rows_) row.fill(kMissing);
  for (const PlannedColumn& column : layout.columns)
    plan_[column.cell] = {
        slot_of(column, kTime, kStageTime, kStage),
        column.scale,
        &column,
        "missing " + column.heading,
        "code " + column.heading,
        limit_of(column),
        column.role == ColumnRole::quantity && consistency_.needs(column.quantity)};
  std::string_view line;
  while (lines_.line_number() + 1 < layout.first_row_line)
    if (!lines_.next(line)) break;
}

bool TableReader::next(Row& row) {
  std::string_view line;
  while (lines_.next(line)) {
    const bool plain = separator_ != 0 && decimal_ == DecimalMark::point && parse_fast(line);
    if (!plain && (skipped(line) || !parse_general(line))) continue;
    if (blank_line_ > 0) {
      if (row.line > 0)
        findings_.note("blank lines", blank_line_, "an empty line inside the table is ignored");
      blank_line_ = 0;
    }
    if (lines_.cut_off())
      findings_.note("cut off", lines_.line_number(),
                     "the last line has no line end: if the file was cut there, its last value may "
                     "be short");
    const Values& values = rows_[now_];
    std::copy_n(values.begin(), kQuantityCount, row.si.begin());
    row.time_s = values[kTime];
    row.stage_time_s = values[kStageTime];
    row.stage = values[kStage];
    row.line = lines_.line_number();
    if (consistency_.is_needed()) consistency_.add(printed_, row.stage, row.line, findings_);
    now_ = 1 - now_;
    return true;
  }
  return false;
}

bool TableReader::parse_fast(std::string_view line) {
  Values& values = rows_[now_];
  const char* at = line.data();
  const char* end = at + line.size();
  bool is_first = true;
  for (const Plan& plan : plan_) {
    if (!std::exchange(is_first, false)) {
      if (at == end || *at != separator_) return false;
      ++at;
    }
    if (plan.slot == kUnwanted) {
      while (at != end && *at != separator_)
        if (*at++ == '"') return false;
      continue;
    }
    double value = 0;
    const char* const begin = at;
    if (!parse_plain(at, end, value) && !parse_long(at, end, value)) return false;
    const double si = value * plan.scale;
    values[plan.slot] = si;
    if (plan.is_compared) keep_printed({begin, static_cast<std::size_t>(at - begin)}, plan);
    // Both are reported by parse_general.
    if (std::abs(si) > plan.limit) return false;
    if (may_be_no_value(value) && plan.slot < kQuantityCount && is_no_value_code(value))
      return false;
  }
  return at == end;
}

bool TableReader::skipped(std::string_view line) {
  if (is_end_mark(line)) {
    findings_.note("end mark", lines_.line_number(),
                   "an end-of-file character (Ctrl-Z) is ignored");
    return true;
  }
  if (trimmed(line).empty()) {
    if (blank_line_ == 0) blank_line_ = lines_.line_number();
    return true;
  }
  if (!layout_.dialect.comment.empty() && line.starts_with(layout_.dialect.comment)) {
    if (layout_.dialect.comment_is_toml) keep_comment(line);
    return true;
  }
  return false;
}

void TableReader::keep_comment(std::string_view line) {
  constexpr std::int64_t kMostLines = 10'000;
  if (trailer_line_ == 0) trailer_line_ = lines_.line_number();
  const auto offset = lines_.line_number() - trailer_line_;
  if (offset > kMostLines || trailer_.size() > kLongestLine)
    throw BadInput(layout_.file, lines_.line_number(),
                   "lines of metadata are below the rows and far from each other: keep them "
                   "together above the headings or at the end");
  auto written = std::ranges::count(trailer_, '\n');
  for (; written < offset; ++written) trailer_ += '\n';
  line.remove_prefix(layout_.dialect.comment.size());
  if (line.starts_with(' ')) line.remove_prefix(1);
  trailer_.append(line).append("\n");
}

bool TableReader::parse_general(std::string_view line) {
  split_cells(line, layout_.separator, cells_);
  if (std::ranges::all_of(cells_, &std::string_view::empty)) {
    findings_.note("empty rows", lines_.line_number(), "a line of empty cells is ignored");
    return false;
  }
  check_cell_count(line);
  for (std::size_t i = 0; i < plan_.size(); ++i) {
    if (plan_[i].slot == kUnwanted) continue;
    parse_number(cells_[i], plan_[i]);
    if (plan_[i].is_compared) keep_printed(cells_[i], plan_[i]);
  }
  return true;
}

void TableReader::keep_printed(std::string_view cell, const Plan& plan) {
  // Of a cell in per cent, whose digits count otherwise, nothing is compared.
  const bool in_percent = cell.ends_with('%');
  printed_[plan.slot] = {in_percent ? kMissing : rows_[now_][plan.slot],
                         half_unit_of(cell) * std::fabs(plan.scale)};
}

void TableReader::check_cell_count(std::string_view line) {
  const auto wanted = plan_.size();
  const auto found = cells_.size();
  if (found == wanted) return;
  const bool only_empty =
      found > wanted && std::all_of(cells_.begin() + static_cast<std::ptrdiff_t>(wanted),
                                    cells_.end(), [](auto cell) { return cell.empty(); });
  if (only_empty) return;
  if (found < wanted && lines_.cut_off())
    throw BadInput(layout_.file, lines_.line_number(),
                   fmt::format("the file is truncated: it ends inside this line, after {} of {} "
                               "cells; copy it again, or remove this line",
                               found, wanted));
  throw BadInput(layout_.file, lines_.line_number(),
                 fmt::format("{} cell{}, but the headings in line {} have {}: {}", found,
                             found == 1 ? "" : "s", layout_.heading_line, wanted, excerpt(line)));
}

/// The last value of the column before this row, as it was printed; NaN if there is none.
double TableReader::previous(Plan& plan) const {
  const double value = rows_[1 - now_][plan.slot] / plan.scale;
  if (!std::isnan(value)) plan.last_before_code = value;
  return plan.last_before_code;
}

/// A code of the logger instead of a value: the cell is missing.
bool TableReader::parse_code(std::string_view cell, Plan& plan, double number) {
  if (plan.slot >= kQuantityCount || !means_no_value(number, previous(plan))) return false;
  rows_[now_][plan.slot] = kMissing;
  findings_.note(plan.code, lines_.line_number(), [&] {
    return fmt::format("column {} has {}, a code for \"no value\": read as missing",
                       excerpt(plan.column->heading), excerpt(cell));
  });
  return true;
}

void TableReader::parse_number(std::string_view cell, Plan& plan) {
  Values& values = rows_[now_];
  const auto before = decimal_;
  double value = kMissing;
  const auto kind = parse_cell(cell, decimal_, value);
  if (before != decimal_ && decimal_ == DecimalMark::comma)
    findings_.note("decimal comma", lines_.line_number(),
                   "the decimal mark is a comma: " + excerpt(cell) + " is read accordingly");
  if (kind == CellKind::text && plan.slot == kTime) {
    if (const auto seconds = clock_seconds(cell)) {
      values[kTime] = clock_.since_start(*seconds);
      findings_.note("clock", lines_.line_number(),
                     "the time is a time of day: counted from the first reading");
      return;
    }
  }
  if (kind == CellKind::text && parse_percent(cell, plan)) return;
  const auto& heading = plan.column->heading;
  const bool empty_only = !layout_.dialect.missing_words;
  const char* remedy = empty_only ? "; leave the cell empty if the reading is missing" : "";
  if (kind == CellKind::missing && empty_only && !cell.empty())
    throw BadInput(layout_.file, lines_.line_number(),
                   fmt::format("column {} has {}, which is not a number{}", excerpt(heading),
                               excerpt(cell), remedy));
  if (kind == CellKind::missing) {
    values[plan.slot] = kMissing;
    findings_.note(plan.missing, lines_.line_number(), [&] {
      return fmt::format("column {} has no value ({})", excerpt(heading), excerpt(cell));
    });
    return;
  }
  if (kind == CellKind::text && cell == heading)
    throw BadInput(layout_.file, lines_.line_number(),
                   "the headings appear again: a second table begins here; split the file");
  if (kind == CellKind::text)
    throw BadInput(
        layout_.file, lines_.line_number(),
        fmt::format("column {} has {}, which is not a number{}", excerpt(heading), excerpt(cell),
                    decimal_ == DecimalMark::open
                        ? ""
                        : fmt::format(" (the decimal mark of this table is '{}')",
                                      static_cast<char>(decimal_))));
  if (kind == CellKind::number && parse_code(cell, plan, value)) return;
  values[plan.slot] = value * plan.scale;
  if (kind == CellKind::out_of_range || !std::isfinite(values[plan.slot]))
    throw BadInput(layout_.file, lines_.line_number(),
                   fmt::format("column {} has {}: not a possible value of an instrument{}",
                               excerpt(heading), excerpt(cell), remedy));
  check_limit(cell, plan);
}

bool TableReader::parse_percent(std::string_view cell, const Plan& plan) {
  constexpr double kPercent = 0.01;
  if (!cell.ends_with('%') || plan.slot >= kQuantityCount ||
      !info(plan.column->quantity).unit.empty())
    return false;
  double value = kMissing;
  if (parse_cell(trimmed(cell.substr(0, cell.size() - 1)), decimal_, value) != CellKind::number)
    return false;
  rows_[now_][plan.slot] = value * kPercent;
  findings_.note("percent", lines_.line_number(),
                 "cells in per cent are read as per cent: " + excerpt(cell));
  return true;
}

void TableReader::check_limit(std::string_view cell, const Plan& plan) const {
  if (!(std::abs(rows_[now_][plan.slot]) > plan.limit)) return;
  const Quantity quantity = plan.column->quantity;
  throw BadInput(layout_.file, lines_.line_number(),
                 fmt::format("column {} has {}, beyond {:g} {}: impossible in a triaxial "
                             "apparatus; check the unit of the column",
                             excerpt(plan.column->heading), excerpt(cell), absurd_of(quantity),
                             info(quantity).unit));
}

}  // namespace triax::lab

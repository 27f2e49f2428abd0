// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/table_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/cells/fill_values.hpp"
#include "lab/intake/text/number_cell.hpp"

namespace triax::lab {
namespace {

std::size_t slot_of(const PlannedColumn& column, std::size_t time, std::size_t first_source) {
  const std::size_t stage_time = time + 1, stage = time + 2, test = time + 3;
  switch (column.role) {
    case ColumnRole::time:
    case ColumnRole::date:
    case ColumnRole::time_of_day:
      return time;
    case ColumnRole::stage_time:
      return stage_time;
    case ColumnRole::stage:
      return stage;
    case ColumnRole::test:
      return test;
    case ColumnRole::source:
      return first_source + index(column.source);
    case ColumnRole::quantity:
      break;
  }
  return index(column.quantity);
}

constexpr const char* kLeaveEmpty = "; leave the cell empty if the reading is missing";

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
      completion_(layout.completion()),
      decimal_(layout.dialect.decimal),
      separator_(character(layout.separator)) {
  for (auto& row : rows_) row.fill(kMissing);
  for (const PlannedColumn& column : layout.columns) {
    plan_[column.cell] = {
        slot_of(column, kTime, kFirstSource),
        column.scale,
        &column,
        "missing " + column.heading,
        "code " + column.heading,
        limit_of(column),
        column.role == ColumnRole::quantity && consistency_.needs(column.quantity),
        kMissing,
        column.clock.has_value(),
        column.role == ColumnRole::test ? &test_names_
        : column.holds_words            ? &stage_names_
                                        : nullptr};
    if (!column.clock || column.role == ColumnRole::stage_time) continue;
    // The midnights that pass are those of the column with the times of day.
    if (!has_clock_ || column.role != ColumnRole::date) clock_ = Clock(*column.clock);
    has_clock_ = true;
    has_date_ = has_date_ || column.role == ColumnRole::date;
    has_time_of_day_ = has_time_of_day_ || column.role != ColumnRole::date;
  }
  std::string_view line;
  while (lines_.line_number() + 1 < layout.first_row_line)
    if (!lines_.next(line)) break;
}

bool TableReader::next(Row& row) {
  std::string_view line;
  while (lines_.next(line)) {
    row_clock_ = {};
    if (layout_.last_row_line > 0 && lines_.line_number() > layout_.last_row_line) return false;
    const bool plain = separator_ != 0 && decimal_ == DecimalMark::point &&
                       layout_.dialect.thousands == 0 && parse_fast(line);
    if (!plain && (skipped(line) || !parse_general(line))) continue;
    if (blank_line_ > 0) {
      if (row.line > 0)
        findings_.note("blank lines", blank_line_, "an empty line inside the table is ignored");
      blank_line_ = 0;
    }
    if (lines_.cut_off())
      findings_.note("cut off", this->line(),
                     "the last line has no line end: if the file was cut there, its last value may "
                     "be short");
    if (has_clock_) finish_clock();
    const Values& values = rows_[now_];
    std::copy_n(values.begin(), kQuantityCount, row.si.begin());
    row.time_s = values[kTime];
    row.stage_time_s = values[kStageTime];
    row.stage = values[kStage];
    row.test = values[kTest];
    row.line = this->line();
    if (completion_.is_needed()) complete(row);
    if (consistency_.is_needed()) consistency_.add(printed_, row.stage, row.line, findings_);
    now_ = 1 - now_;
    return true;
  }
  return false;
}

void TableReader::complete(Row& row) {
  RowValues all{.si = row.si};
  std::copy_n(rows_[now_].begin() + kFirstSource, kSourceCount, all.source.begin());
  completion_.complete(all);
  row.si = all.si;
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
    if (plan.words) return false;
    if (plan.has_clock) {
      if (!skip_clock(at, end, plan)) return false;
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
    if (may_be_fill_number(value) && plan.slot < kQuantityCount && is_fill_number(value))
      return false;
  }
  return at == end;
}

bool TableReader::skipped(std::string_view text) {
  if (std::ranges::binary_search(layout_.other_lines, line())) return true;
  if (std::ranges::find(layout_.heading_texts, text) != layout_.heading_texts.end()) {
    findings_.note("headings again", line(), "the headings appear again and are ignored");
    return true;
  }
  if (is_end_mark(text)) {
    findings_.note("end mark", line(), "an end-of-file character (Ctrl-Z) is ignored");
    return true;
  }
  if (trimmed(text).empty()) {
    if (blank_line_ == 0) blank_line_ = line();
    return true;
  }
  if (begins_with_comment(text, layout_.dialect.comment)) {
    if (layout_.dialect.comment_is_toml) keep_comment(text);
    return true;
  }
  return false;
}

void TableReader::keep_comment(std::string_view text) {
  constexpr std::int64_t kMaxLines = 10'000;
  if (trailer_line_ == 0) trailer_line_ = line();
  const auto offset = line() - trailer_line_;
  if (offset > kMaxLines || trailer_.size() > kMaxLine_bytes)
    throw BadInput(layout_.file, line(),
                   "lines of metadata are below the rows and far from each other: keep them "
                   "together above the headings or at the end");
  auto written = std::ranges::count(trailer_, '\n');
  for (; written < offset; ++written) trailer_ += '\n';
  text.remove_prefix(layout_.dialect.comment.size());
  if (text.starts_with(' ')) text.remove_prefix(1);
  trailer_.append(text).append("\n");
}

bool TableReader::parse_general(std::string_view text) {
  split_cells(text, layout_.separator, cells_);
  if (std::ranges::all_of(cells_, &std::string_view::empty)) {
    findings_.note("empty rows", line(), "a line of empty cells is ignored");
    return false;
  }
  if (cells_.size() < plan_.size() && !lines_.cut_off()) layout_.extents.place(text, cells_);
  if (layout_.block_cells > 0 && is_beside_block()) return false;
  check_cell_count(text);
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

/// A row of longer tables beside this one.
bool TableReader::is_beside_block() {
  cells_.resize(std::max(cells_.size(), plan_.size()));
  const auto cells = std::span(cells_).subspan(layout_.first_cell, layout_.block_cells);
  return std::ranges::all_of(cells, &std::string_view::empty);
}

void TableReader::check_cell_count(std::string_view text) {
  const auto wanted = plan_.size();
  const auto found = cells_.size();
  if (found == wanted) return;
  const bool only_empty =
      found > wanted && std::all_of(cells_.begin() + static_cast<std::ptrdiff_t>(wanted),
                                    cells_.end(), [](auto cell) { return cell.empty(); });
  if (only_empty) return;
  if (found < wanted && lines_.cut_off())
    throw BadInput(layout_.file, line(),
                   fmt::format("the file is truncated: it ends inside this line, after {} of {} "
                               "cells; copy it again, or remove this line",
                               found, wanted));
  throw BadInput(layout_.file, line(),
                 fmt::format("{} cell{}, but the headings in line {} have {}: {}", found,
                             found == 1 ? "" : "s", layout_.heading_line, wanted, excerpt(text)));
}

/// The last value of the column before this row, as it was printed; NaN if there is none.
double TableReader::previous(Plan& plan) const {
  const double value = rows_[1 - now_][plan.slot] / plan.scale;
  if (!std::isnan(value)) plan.last_before_code = value;
  return plan.last_before_code;
}

/// A clock's cell at `at`, to the separator; false for anything that parse_clock must look at.
bool TableReader::skip_clock(const char*& at, const char* end, const Plan& plan) {
  const bool is_quoted = at != end && *at == '"';
  const char* const begin = is_quoted ? at + 1 : at;
  const char* const stop = std::find(begin, end, is_quoted ? '"' : separator_);
  if (is_quoted && stop == end) return false;
  const auto time =
      read_clock(*plan.column->clock, trimmed({begin, static_cast<std::size_t>(stop - begin)}));
  if (!time) return false;
  keep_clock(*time, plan);
  at = is_quoted ? stop + 1 : stop;
  return true;
}

void TableReader::parse_clock(std::string_view cell, const Plan& plan) {
  if (const auto time = read_clock(*plan.column->clock, cell)) {
    keep_clock(*time, plan);
  } else if (!is_fill_text(cell)) {
    refuse_text(cell, plan);
  } else if (plan.column->role != ColumnRole::date) {  // a date may be printed once a day
    keep_missing(cell, plan);
  }
}

void TableReader::keep_clock(const ClockTime& time, const Plan& plan) {
  const auto role = plan.column->role;
  if (role == ColumnRole::stage_time) {
    rows_[now_][kStageTime] = Clock::seconds(time);
    return;
  }
  if (role == ColumnRole::date || !has_date_) row_clock_.day = time.day;
  // A date without a time of day is its midnight, unless that is in another column.
  const bool has_own_time = role != ColumnRole::date;
  if (has_own_time || !has_time_of_day_) row_clock_.time_ns = time.time_ns.value_or(0);
}

void TableReader::finish_clock() {
  rows_[now_][kTime] = row_clock_.time_ns ? clock_.since_start(row_clock_) : kMissing;
}

/// A code of the logger instead of a value: the cell is missing.
bool TableReader::parse_code(std::string_view cell, Plan& plan, double number) {
  if (plan.slot >= kQuantityCount || !means_no_value(number, previous(plan))) return false;
  rows_[now_][plan.slot] = kMissing;
  findings_.note(plan.code, line(), [&] {
    return fmt::format("column {} has {}, a code for \"no value\": read as missing",
                       excerpt(plan.column->heading), excerpt(cell));
  });
  return true;
}

void TableReader::keep_missing(std::string_view cell, const Plan& plan) {
  const auto& heading = plan.column->heading;
  if (!layout_.dialect.missing_words && !cell.empty())
    throw BadInput(layout_.file, line(),
                   fmt::format("column {} has {}, which is not a number{}", excerpt(heading),
                               excerpt(cell), kLeaveEmpty));
  rows_[now_][plan.slot] = kMissing;
  findings_.note(plan.missing, line(), [&] {
    return fmt::format("column {} has no value ({})", excerpt(heading), excerpt(cell));
  });
}

/// "34 (hard to read)", "34?": whoever wrote the remark does not vouch for the number.
bool TableReader::parse_remark(std::string_view cell, const Plan& plan) {
  if (!layout_.dialect.missing_words || plan.slot >= kQuantityCount) return false;
  const auto end = cell.find_first_of("([?*");
  double value = kMissing;
  if (end == std::string_view::npos ||
      parse_cell(trimmed(cell.substr(0, end)), decimal_, value) != CellKind::number)
    return false;
  rows_[now_][plan.slot] = kMissing;
  findings_.note(plan.missing, line(), [&] {
    return fmt::format("column {} has {}, a number with a remark: read as missing",
                       excerpt(plan.column->heading), excerpt(cell));
  });
  return true;
}

void TableReader::refuse_text(std::string_view cell, const Plan& plan) const {
  const auto& heading = plan.column->heading;
  if (cell == heading)
    throw BadInput(layout_.file, line(),
                   "other headings begin here: a second table; split the file");
  const auto expected =
      plan.has_clock ? "does not fit this column: " + describe(*plan.column->clock)
      : decimal_ == DecimalMark::open
          ? std::string("is not a number")
          : fmt::format("is not a number (the decimal mark of this table is '{}')",
                        static_cast<char>(decimal_));
  throw BadInput(
      layout_.file, line(),
      fmt::format("column {} has {}, which {}", excerpt(heading), excerpt(cell), expected));
}

void TableReader::parse_number(std::string_view cell, Plan& plan) {
  if (plan.has_clock) {
    parse_clock(cell, plan);
    return;
  }
  if (plan.words) {
    keep_word(cell, plan);
    return;
  }
  Values& values = rows_[now_];
  const auto before = decimal_;
  double value = kMissing;
  const auto kind = decimal_ == DecimalMark::open
                        ? parse_cell(cell, decimal_, value)
                        : parse_number_cell(cell, {decimal_, layout_.dialect.thousands}, value);
  if (before != decimal_ && decimal_ == DecimalMark::comma)
    findings_.note("decimal comma", line(),
                   "the decimal mark is a comma: " + excerpt(cell) + " is read accordingly");
  if (kind == CellKind::text && (parse_percent(cell, plan) || parse_remark(cell, plan))) return;
  if (kind == CellKind::text) refuse_text(cell, plan);
  if (kind == CellKind::missing) {
    keep_missing(cell, plan);
    return;
  }
  if (kind == CellKind::number && parse_code(cell, plan, value)) return;
  values[plan.slot] = value * plan.scale;
  if (kind == CellKind::out_of_range || !std::isfinite(values[plan.slot]))
    throw BadInput(layout_.file, line(),
                   fmt::format("column {} has {}: not a possible value of an instrument{}",
                               excerpt(plan.column->heading), excerpt(cell),
                               layout_.dialect.missing_words ? "" : kLeaveEmpty));
  check_limit(cell, plan);
}

double TableReader::WordNumbers::of(std::string_view word) {
  const auto known = numbers_.find(word);
  if (known != numbers_.end()) return known->second;
  words_.emplace_back(word);
  const auto number = static_cast<double>(words_.size());
  numbers_.emplace(words_.back(), number);
  return number;
}

/// An empty cell is that of the row above.
void TableReader::keep_word(std::string_view cell, const Plan& plan) {
  constexpr std::size_t kMaxWords = 10'000;
  const std::string_view word = trimmed(cell);
  double& value = rows_[now_][plan.slot];
  value = word.empty() ? rows_[1 - now_][plan.slot] : plan.words->of(word);
  if (plan.words->all().size() > kMaxWords)
    throw BadInput(layout_.file, line(),
                   fmt::format("column {} has more than {} different names",
                               excerpt(plan.column->heading), kMaxWords));
}

std::string TableReader::test_name() const {
  const double number = rows_[1 - now_][kTest];
  return std::isnan(number) ? std::string()
                            : test_names_.all()[static_cast<std::size_t>(number) - 1];
}

std::int64_t TableReader::line() const {
  const std::int64_t number = lines_.line_number();
  const bool is_row = number >= layout_.first_row_line && number <= layout_.last_row_line;
  return layout_.is_reversed && is_row ? layout_.first_row_line + layout_.last_row_line - number
                                       : number;
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
  findings_.note("percent", line(), "cells in per cent are read as per cent: " + excerpt(cell));
  return true;
}

void TableReader::check_limit(std::string_view cell, const Plan& plan) const {
  if (!(std::abs(rows_[now_][plan.slot]) > plan.limit)) return;
  const Quantity quantity = plan.column->quantity;
  throw BadInput(layout_.file, line(),
                 fmt::format("column {} has {}, beyond {:g} {}: impossible in a triaxial "
                             "apparatus; check the unit of the column",
                             excerpt(plan.column->heading), excerpt(cell), absurd_of(quantity),
                             info(quantity).unit));
}

}  // namespace triax::lab

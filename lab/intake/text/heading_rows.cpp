// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/heading_rows.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

/// A line above the rows as cells.
struct HeadingLine {
  std::size_t line = 0;
  std::vector<std::string_view> cells;  // without empty cells at the end
  std::size_t cell_count = 0;
  std::size_t texts = 0, numbers = 0, filled = 0;
  std::size_t fill_words = 0;  ///< "NAN", "n/a", not "-"
  bool is_comment = false;

  bool has_text(std::size_t column) const {
    return column < cells.size() && find_shape(cells[column]).shape == CellShape::text;
  }
};

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }));
}

std::vector<std::string_view> single_blank_cells(std::string_view text) {
  std::vector<std::string_view> cells;
  for (auto at = text.find(' '); at != std::string_view::npos; at = text.find(' ')) {
    cells.push_back(text.substr(0, at));
    text.remove_prefix(at + 1);
  }
  cells.push_back(text);
  return cells;
}

HeadingLine split_line(std::string_view text, std::size_t line, Separator separator,
                       std::size_t width) {
  HeadingLine out;
  out.line = line;
  const auto mark = comment_mark(text, separator);
  out.cells = cells_of(text, separator);
  if (!mark.empty()) {
    const auto body = text.substr(text.find(mark) + mark.size());
    auto cells = cells_of(text.find('"') < text.find(mark) ? text : body, separator);
    // "# Time" has a mark, "#;Time" and "% kPa" have a cell in its place.
    out.is_comment = out.cells.size() != width || cells.size() == width;
    if (out.is_comment) out.cells = std::move(cells);
    if (out.is_comment && !out.cells.empty() && out.cells.front().starts_with(mark))
      out.cells.front() = trimmed(out.cells.front().substr(mark.size()));
  }
  // Names of groups between single spaces: an empty cell is one space more.
  if (separator == Separator::blanks && out.cells.size() < width) {
    const auto body = mark.empty() ? text : text.substr(text.find(mark) + mark.size());
    auto cells = single_blank_cells(mark.empty() || !body.starts_with(' ') ? body : body.substr(1));
    if (cells.size() == width) out.cells = std::move(cells);
  }
  out.cell_count = out.cells.size();
  while (!out.cells.empty() && out.cells.back().empty()) out.cells.pop_back();
  for (const auto cell : out.cells) {
    const auto shape = find_shape(cell).shape;
    out.texts += shape == CellShape::text ? 1 : 0;
    out.numbers += is_value(shape) && shape != CellShape::fill ? 1 : 0;
    out.filled += shape == CellShape::empty ? 0 : 1;
    const bool is_word = std::ranges::any_of(
        cell, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
    out.fill_words += shape == CellShape::fill && is_word ? 1 : 0;
  }
  return out;
}

/// "Client;Muster;;Hole;B3": names and values, apart by an empty cell.
bool is_pairs(const HeadingLine& line) {
  if (line.cells.size() % 3 != 2) return false;
  for (std::size_t i = 0; i < line.cells.size(); ++i)
    if (line.cells[i].empty() != (i % 3 == 2)) return false;
  return true;
}

/// "Avg;Avg;Smp": how values were taken.
bool is_statistic(const HeadingLine& line) {
  constexpr std::array<std::string_view, 12> kWords{
      "avg", "smp", "min", "max", "std", "tot", "rms", "sum", "med", "sample", "average", "mean"};
  return std::ranges::all_of(line.cells, [&](std::string_view cell) {
    return cell.empty() || std::ranges::find(kWords, folded(cell)) != kWords.end();
  });
}

/// "Logger: 8-ch;Serial 0417": what describes a file, not its columns.
bool is_remark(std::string_view cell) {
  const auto is_figure = [](char c) { return c >= '0' && c <= '9'; };
  const auto* const pair = std::ranges::adjacent_find(
      cell, [&](char a, char b) { return is_figure(a) && is_figure(b); });
  return cell.find(':') != std::string_view::npos || pair != cell.end();
}

/// Fraction of the filled cells that have the form of a unit, or are short and come three times.
double unit_fraction(const HeadingLine& line) {
  constexpr std::size_t kMaxUnit = 8;
  if (is_statistic(line)) return 0;
  std::map<std::string_view, std::size_t> counts;
  for (const auto cell : line.cells) ++counts[cell];
  std::size_t units = 0;
  std::size_t filled = 0;
  for (const auto cell : line.cells) {
    if (cell.empty() || find_shape(cell).shape == CellShape::fill) continue;
    ++filled;
    units += has_unit_form(cell) || (counts[cell] > 2 && characters(cell) <= kMaxUnit) ? 1 : 0;
  }
  return filled > 0 ? static_cast<double>(units) / static_cast<double>(filled) : 0;
}

constexpr double kMinUnits = 0.6;  ///< fraction of units in a line of units

class HeadingSearch {
 public:
  HeadingSearch(const TableSample& sample, const RowModel& rows, Separator separator)
      : sample_(sample), rows_(rows), separator_(separator), has_name_(rows.width, 0) {}

  HeadingRows run(bool with_numbers) {
    with_numbers_ = with_numbers;
    collect();
    return result();
  }

 private:
  void collect() {
    constexpr std::size_t kMaxLines = 5;
    constexpr std::size_t kMaxRemarks = 2;
    std::size_t remarks = 0;
    for (std::size_t i = rows_.first; i-- > 0 && found_.size() < kMaxLines;) {
      const std::string& text = sample_.line(i);
      if (is_numbering(text, separator_)) continue;
      const auto line = split_line(text, i, separator_, rows_.width);
      if (line.filled == 0) {
        if (is_complete()) break;
        continue;
      }
      if (line.texts == 0 && line.numbers == 0) continue;  // drawn lines
      if (2 * line.fill_words >= line.filled) continue;    // a row without values
      if (is_heading(line)) {
        add(line);
      } else if (is_complete() || !(line.is_comment || (found_.empty() && line.filled == 1 &&
                                                        ++remarks <= kMaxRemarks))) {
        break;
      }
    }
  }

  bool is_complete() const {
    std::size_t used = 0;
    std::size_t named = 0;
    for (std::size_t column = 0; column < rows_.width; ++column) {
      if (!rows_.is_used(column)) continue;
      ++used;
      named += static_cast<std::size_t>(has_name_[column]);
    }
    return named > 0 && named + 1 >= used;
  }

  bool is_full(const HeadingLine& line) const {
    for (std::size_t column = 0; column < rows_.width; ++column)
      if (rows_.is_used(column) && !line.has_text(column)) return false;
    return true;
  }

  bool fits(const HeadingLine& line) const {
    const std::size_t more = character(separator_) == 0 ? 0 : 1;
    if (line.texts == 0 || line.cells.size() > rows_.width + more) return false;
    return line.numbers == 0 || (with_numbers_ && ends_in_numbers(line));
  }

  /// "strain;100;200;300": one cell per column, names first.
  bool ends_in_numbers(const HeadingLine& line) const {
    const auto is_text = [](std::string_view cell) {
      return find_shape(cell).shape == CellShape::text;
    };
    return line.cells.size() == rows_.width && line.filled == rows_.width &&
           std::ranges::is_partitioned(line.cells, is_text);
  }

  bool is_heading(const HeadingLine& line) const {
    if (!fits(line)) return false;
    if (is_of_units(line) && line.cell_count == rows_.width) return true;
    if (is_complete()) return is_group(line);
    const bool is_half = with_numbers_ || 2 * (line.filled - line.numbers) >= used();
    return line.filled >= 2 && (is_half || (!found_.empty() && has_names()));
  }

  /// A line above complete names: names of groups of columns, or the first part of the names.
  bool is_group(const HeadingLine& line) const {
    if (!has_names()) return is_full(line);
    if (line.filled < 2) return false;
    const bool is_padded = line.cell_count > line.cells.size();
    const bool has_gap = line.filled < line.cells.size();
    if (character(separator_) == 0) return is_padded || has_gap;
    if (!has_gap && (line.filled < 3 || std::ranges::any_of(line.cells, is_remark))) return false;
    if (line.cell_count == rows_.width && is_padded) return true;
    return !is_pairs(line) && 2 * line.cells.size() > rows_.width;
  }

  static bool is_of_units(const HeadingLine& line) {
    return is_statistic(line) || unit_fraction(line) >= kMinUnits;
  }

  std::size_t used() const {
    std::size_t count = 0;
    for (std::size_t column = 0; column < rows_.width; ++column)
      count += rows_.is_used(column) ? 1 : 0;
    return count;
  }

  /// False as long as only units and statistics were found. Above units, "t;d;P" are names.
  bool has_names() const { return has_names_; }

  void add(const HeadingLine& line) {
    const bool has_units = std::ranges::any_of(
        found_, [](const HeadingLine& one) { return unit_fraction(one) >= kMinUnits; });
    found_.push_back(line);
    if (is_statistic(line) || (is_of_units(line) && !has_units)) return;
    has_names_ = true;
    for (std::size_t column = 0; column < rows_.width; ++column)
      has_name_[column] =
          has_name_[column] != 0 || (column < line.cells.size() && !line.cells[column].empty()) ? 1
                                                                                                : 0;
  }

  std::vector<std::string> padded(const HeadingLine& line) const {
    std::vector<std::string> cells(line.cells.begin(), line.cells.end());
    cells.resize(rows_.width);
    return cells;
  }

  HeadingRows result() {
    HeadingRows out;
    if (found_.empty()) return out;
    std::ranges::reverse(found_);
    out.top = found_.front().line;
    std::optional<std::size_t> unit;
    double most = kMinUnits;
    for (std::size_t i = 0; i < found_.size() && found_.size() > 1; ++i)
      if (const double units = unit_fraction(found_[i]); units >= most) {
        most = units;
        unit = i;
      }
    const bool below = unit && *unit == 0;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (unit && (i == *unit || (i > *unit) != below)) continue;
      if (!unit && i > 0 && is_statistic(found_[i])) continue;
      out.lines.push_back(found_[i].line);
      out.cells.push_back(padded(found_[i]));
    }
    if (unit) {
      out.unit_line = found_[*unit].line;
      out.units = padded(found_[*unit]);
    }
    out.coverage = named(out.cells);
    return out;
  }

  double named(const std::vector<std::vector<std::string>>& lines) const {
    std::size_t count = 0;
    for (std::size_t column = 0; column < rows_.width; ++column)
      count += rows_.is_used(column) &&
                       std::ranges::any_of(
                           lines, [&](const auto& cells) { return !cells[column].empty(); })
                   ? 1
                   : 0;
    return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(used(), 1));
  }

  const TableSample& sample_;
  const RowModel& rows_;
  Separator separator_;
  bool with_numbers_ = false;
  bool has_names_ = false;
  std::vector<char> has_name_;
  std::vector<HeadingLine> found_;
};

/// The name in "3: Load [kN]", "Column 3 = Load" or "# 3 Load", if the line has this number.
std::string_view listed_name(std::string_view line, std::size_t number) {
  constexpr std::size_t kMaxBefore = 12;  // "Channel (3)"
  constexpr std::string_view kBetween = " \t:=.;,)]-";
  const auto digit = line.find_first_of("0123456789");
  if (digit > kMaxBefore) return {};
  if (line.substr(0, digit).find_first_of(":=;,") != std::string_view::npos) return {};
  line.remove_prefix(digit);
  const auto figures = std::min(line.find_first_not_of("0123456789"), line.size());
  if (line.substr(0, figures) != fmt::format_int(number).str()) return {};
  line.remove_prefix(figures);
  const auto name = line.find_first_not_of(kBetween);
  if (name == 0 || name == std::string_view::npos) return {};
  line = trimmed(line.substr(name));
  return find_shape(line).shape == CellShape::text ? line : std::string_view{};
}

/// Names that are below each other in numbered lines, one per column.
HeadingRows find_listed_names(const TableSample& sample, const RowModel& rows) {
  HeadingRows out;
  std::vector<std::size_t> lines;
  for (std::size_t i = rows.first; i-- > 0 && lines.size() < rows.width;)
    if (!rows.lines[i].is_blank()) lines.push_back(i);
  if (lines.size() < rows.width) return out;
  std::ranges::reverse(lines);
  for (const std::size_t start : {0, 1}) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < lines.size(); ++k)
      if (const auto name = listed_name(sample.line(lines[k]), k + start); !name.empty())
        names.emplace_back(name);
    if (names.size() < rows.width) continue;
    out.top = lines.front();
    out.lines = lines;
    out.cells.push_back(names);
    out.coverage = 1;
  }
  return out;
}

/// The units of a line farther above that names them: "Y_Unit_Label;N;mm;kPa" in the header of
/// LabVIEW, with the name above the column of the time.
void add_named_units(HeadingRows& headings, const TableSample& sample, const RowModel& rows) {
  if (headings.unit_line || headings.lines.empty() || character(rows.separator) == 0) return;
  for (std::size_t i = headings.top; i-- > 0;) {
    const auto line = split_line(sample.line(i), i, rows.separator, rows.width);
    if (line.cells.size() < 3 || line.cells.size() > rows.width) continue;
    const std::string name = folded(line.cells.front());
    if (name.find("unit") == std::string::npos || has_unit_form(name)) continue;
    const auto is_unit = [](std::string_view cell) { return cell.empty() || has_unit_form(cell); };
    if (!std::all_of(line.cells.begin() + 1, line.cells.end(), is_unit)) continue;
    headings.unit_line = i;
    headings.units.assign(line.cells.begin(), line.cells.end());
    headings.units.front().clear();
    headings.units.resize(rows.width);
    return;
  }
}

}  // namespace

bool has_unit_form(std::string_view cell) {
  constexpr std::size_t kMaxUnit = 12;
  static const std::set<std::string_view> words{
      "-",      "%",    "‰",    "ts",     "rn",      "s",    "sec",  "secs", "second", "seconds",
      "min",    "mins", "min.", "minute", "minutes", "h",    "hr",   "hrs",  "hour",   "hours",
      "d",      "ms",   "mm",   "cm",     "m",       "um",   "µm",   "in",   "in.",    "inch",
      "inches", "pulg", "ft",   "pa",     "kpa",     "mpa",  "bar",  "mbar", "psi",    "psig",
      "psf",    "ksf",  "tsf",  "ksc",    "n",       "kn",   "lb",   "lbs",  "lbf",    "kp",
      "kg",     "kgf",  "kgs",  "t",      "tf",      "ml",   "cc",   "cu",   "sq",     "v",
      "mv",     "div",  "c",    "°c",     "degc",    "deg",  "с",    "сек",  "мин",    "ч",
      "м",      "мм",   "см",   "мл",     "Па",      "кПа",  "МПа",  "бар",  "Н",      "кН",
      "кг",     "кгс",  "д.е.", "秒",     "分",      "小时", "分钟", "时",   "℃"};
  if (cell == "-") return false;
  if (cell.size() > 2 && (cell.front() == '(' || cell.front() == '[') &&
      (cell.back() == ')' || cell.back() == ']'))
    cell = trimmed(cell.substr(1, cell.size() - 2));
  if (cell.empty() || characters(cell) > kMaxUnit) return false;
  if (cell.find_first_of("([", 1) != std::string_view::npos) return false;  // "d [mm]" is a name
  std::string word = folded(cell);
  if (word.starts_with("0.01 ") || word.starts_with("0.001 ")) word.erase(0, word.find(' ') + 1);
  // "kgf/cm²" by its first part, "mm³" and "mm^3" without the power.
  word.resize(std::min(word.find_first_of("/*^ "), word.size()));
  for (const std::string_view power : {"2", "3", "²", "³", ".2"})
    if (word.size() > power.size() && word.ends_with(power))
      word.resize(word.size() - power.size());
  return words.contains(word);
}

HeadingRows find_heading_rows(const TableSample& sample, const RowModel& rows) {
  constexpr std::array kOthers{Separator::tab,       Separator::wide_blanks, Separator::comma,
                               Separator::semicolon, Separator::pipe,        Separator::blanks};
  constexpr double kOfAnother = 0.5;  // what headings behind another separator count
  if (auto listed = find_listed_names(sample, rows); !listed.lines.empty()) return listed;
  auto best = HeadingSearch(sample, rows, rows.separator).run(false);
  if (best.lines.empty()) best = HeadingSearch(sample, rows, rows.separator).run(true);
  add_named_units(best, sample, rows);
  if (!best.lines.empty()) return best;
  for (const auto separator : kOthers) {
    if (separator == rows.separator) continue;
    auto found = HeadingSearch(sample, rows, separator).run(false);
    if (found.coverage < 1) continue;
    found.coverage *= kOfAnother;
    return found;
  }
  return best;
}

}  // namespace triax::lab

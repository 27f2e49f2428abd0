// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/cell_shape.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMaxShapeLength = 48;  ///< bytes of the longest number or clock

bool is_figure(char c) { return static_cast<unsigned>(c - '0') < 10U; }
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

/// The cell with ASCII in place of the signs, digits and spaces of Unicode.
std::string plain_signs(std::string_view cell) {
  constexpr std::array<std::pair<std::string_view, char>, 10> kSigns{{{"\u2212", '-'},
                                                                      {"\u2013", '-'},
                                                                      {"\uFF0D", '-'},
                                                                      {"\u00A0", ' '},
                                                                      {"\u202F", ' '},
                                                                      {"\u2009", ' '},
                                                                      {"\u2019", '\''},
                                                                      {"\uFF0E", '.'},
                                                                      {"\uFF0C", ','},
                                                                      {"\uFF1A", ':'}}};
  constexpr std::string_view kWideZero = "\uFF10";
  std::string out;
  while (!cell.empty()) {
    const auto* const sign =
        std::ranges::find_if(kSigns, [&](const auto& one) { return cell.starts_with(one.first); });
    if (sign != kSigns.end()) {
      out += sign->second;
      cell.remove_prefix(sign->first.size());
      continue;
    }
    if (cell.size() >= 3 && cell.starts_with(kWideZero.substr(0, 2)) &&
        static_cast<unsigned>(cell[2] - kWideZero[2]) < 10U) {
      out += static_cast<char>('0' + (cell[2] - kWideZero[2]));
      cell.remove_prefix(3);
      continue;
    }
    out += cell.front();
    cell.remove_prefix(1);
  }
  return out;
}

/// Groups of digits between `mark`: three at the end, two or three between, no leading zero.
bool are_groups(std::string_view digits, char mark) {
  if (digits.front() == '0') return false;
  std::size_t run = 0;
  bool first = true;
  for (const char c : digits) {
    if (is_figure(c)) {
      ++run;
    } else {
      if (c != mark || run == 0 || run > 3 || (!first && run < 2)) return false;
      first = false;
      run = 0;
    }
  }
  return run == 3;
}

bool fits_format(std::string_view mantissa, const NumberFormat& format) {
  const auto at = mantissa.find(static_cast<char>(format.decimal));
  const auto whole = mantissa.substr(0, at);
  const auto rest = at == std::string_view::npos ? std::string_view{} : mantissa.substr(at + 1);
  if (!std::ranges::all_of(rest, is_figure) || (whole.empty() && rest.empty())) return false;
  if (std::ranges::all_of(whole, is_figure)) return true;
  return format.thousands != 0 && are_groups(whole, format.thousands);
}

/// Cuts the exponent of a number; false if there is text that is none.
bool cut_exponent(std::string_view& number) {
  const auto at = number.find_first_of("eEdD");
  if (at == std::string_view::npos) return true;
  auto power = number.substr(at + 1);
  if (power.starts_with('-') || power.starts_with('+')) power.remove_prefix(1);
  number = number.substr(0, at);
  return !power.empty() && power.size() <= 3 && std::ranges::all_of(power, is_figure);
}

std::uint8_t formats_of(std::string_view number) {
  if (number.starts_with('(') && number.ends_with(')'))
    number = number.substr(1, number.size() - 2);
  if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
  if (!cut_exponent(number) || number.empty()) return 0;
  std::uint8_t formats = 0;
  for (std::size_t i = 0; i < kNumberFormats.size(); ++i)
    if (fits_format(number, kNumberFormats[i])) formats |= static_cast<std::uint8_t>(1U << i);
  return formats;
}

/// Parts of a clock: takes them from the front of a text.
class ClockParts {
 public:
  explicit ClockParts(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  void skip_blanks() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
  }
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::size_t take_digits(std::size_t max) { return take_run(is_figure, max); }
  std::size_t take_letters(std::size_t max) { return take_run(is_letter, max); }

  /// "2026-03-09", "9/3/26", "09.03.2026", "9-Mar-2026", "9 mars 2026", "2026年3月9日".
  bool take_date() {
    const auto begin = rest_;
    const auto first = take_digits(4);
    const auto mark = rest_;
    bool good = first > 0 && (take('-') || take('/') || take('.') || take(' ') || take_letters(3));
    if (good && (mark.front() == ' ' || !take_digits(2))) good = take_month();
    if (good) {
      const auto next = rest_;
      good = (take('-') || take('/') || take('.') || take(' ') || take_letters(3)) &&
             (next.front() == mark.front() || is_letter(mark.front()) || mark.front() == ' ' ||
              next.front() == ' ');
    }
    const auto last = good ? take_digits(4) : 0;
    if (last > 0 && is_letter(mark.front())) take_letters(3);
    if (last > 0 && (first <= 2 || first == 4)) return true;
    rest_ = begin;
    return false;
  }

  /// "10:00", "1:02:03.5", "123:00:00", and what follows: AM, PM, Z, +01:00.
  bool take_time() {
    const auto begin = rest_;
    bool good = take_digits(6) > 0;
    for (int part = 0; good && part < 3 && take(':'); ++part) {
      good = take_digits(2) == 2;
      if (good && part == 2) break;
    }
    if (!good || begin.substr(0, begin.size() - rest_.size()).find(':') == std::string_view::npos) {
      rest_ = begin;
      return false;
    }
    if (take('.') || take(',') || take(':')) take_digits(9);
    take_zone();
    return true;
  }

 private:
  template <class Is>
  std::size_t take_run(Is is, std::size_t max) {
    std::size_t count = 0;
    while (count < max && count < rest_.size() && is(rest_[count])) ++count;
    rest_.remove_prefix(count);
    return count;
  }
  bool take_month() {
    constexpr std::size_t kMaxMonth = 18;
    const bool good = take_letters(kMaxMonth) >= 3;
    if (good) take('.');
    return good;
  }
  void take_zone() {
    skip_blanks();
    const auto word = folded(rest_);
    for (const std::string_view half : {"am", "pm", "a.m.", "p.m.", "a. m.", "p. m.", "z"})
      if (word == half) rest_ = {};
    if ((take('+') || take('-')) && take_digits(4) > 0 && take(':')) take_digits(2);
  }

  std::string_view rest_;
};

bool is_clock(std::string_view text) {
  ClockParts parts(text);
  const bool date = parts.take_date();
  if (date && parts.at_end()) return true;
  if (date && !parts.take(' ') && !parts.take('T') && !parts.take(',')) return false;
  parts.skip_blanks();
  return parts.take_time() && parts.at_end();
}

/// Texts that spreadsheets write for an error: "#DIV/0!", "#N/A", "#NOME?".
bool is_sheet_error(std::string_view cell) {
  if (!cell.starts_with('#') || cell.size() < 3) return false;
  return cell.ends_with('!') || cell.ends_with('?') || cell == "#N/A" || cell == "#N/D" ||
         cell == "#NV";
}

bool is_fill(std::string_view cell) {
  constexpr std::array<std::string_view, 45> kWords{
      "-",         "--",     "---",        "nan",  "-nan", "nan(ind)", "-nan(ind)", "na",
      "n/a",       "n.a.",   "n/d",        "n.d.", "null", "none",     "nil",       "missing",
      "no data",   "nodata", "inf",        "+inf", "-inf", "infinity", "ovrflo",    "overflow",
      "overload",  "ovld",   "ovl",        "ol",   "o.l.", "+over",    "-over",     "over",
      "overrange", "under",  "underrange", "open", "err",  "error",    "fault",     "invalid",
      "?",         "k.a.",   "s/d",        "нет",  "无"};
  if (is_sheet_error(cell)) return true;
  if (std::ranges::all_of(cell, [](char c) { return c == '*'; })) return true;
  const auto word = folded(cell);
  if (std::ranges::find(kWords, word) != kWords.end()) return true;
  if (word.find(".#") != std::string::npos) return true;  // 1.#QNAN of old run-time libraries
  return (word.starts_with('<') || word.starts_with('>')) && formats_of(word.substr(1)) != 0;
}

bool is_rule(std::string_view cell) {
  return cell.size() >= 3 &&
         std::string_view("-=_+~.").find(cell.front()) != std::string_view::npos &&
         std::ranges::all_of(cell, [&](char c) { return c == cell.front() || c == '+'; });
}

}  // namespace

ShapedCell find_shape(std::string_view cell) {
  if (cell.empty()) return {};
  if (cell.size() <= kMaxShapeLength) {
    const bool ascii = std::ranges::all_of(cell, [](char c) { return c >= 0; });
    const std::string copy = ascii ? std::string() : plain_signs(cell);
    const std::string_view text = ascii ? cell : std::string_view(copy);
    if (const auto formats = formats_of(text); formats != 0) return {CellShape::number, formats};
    if (is_clock(text)) return {CellShape::clock};
    if (is_fill(cell)) return {CellShape::fill};
  }
  return {is_rule(cell) ? CellShape::rule : CellShape::text};
}

}  // namespace triax::lab

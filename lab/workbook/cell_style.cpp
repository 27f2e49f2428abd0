// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/cell_style.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace triax::lab {
namespace {

constexpr long long kMillisecondsOfDay = 86'400'000;
constexpr double kLastDay = 2'958'466;  // 9999-12-31
constexpr long long kFrom1904 = 1462;   // days between the two counts
constexpr long long kLastHours = 61;    // days that a time of day can be hours of

std::string clock_text(long long milliseconds) {
  const auto seconds = milliseconds / 1000, rest = milliseconds % 1000;
  auto text = fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  if (rest > 0) text += fmt::format(".{:03}", rest);
  return text;
}

std::string day_text(long long days) {
  namespace ch = std::chrono;
  // Day 0 is 1899-12-30, since the count has a 29th of February 1900 that never was.
  const ch::year_month_day date{ch::sys_days{ch::year{1899} / 12 / 30} +
                                ch::days{days < 61 ? days + 1 : days}};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

}  // namespace

CellStyle style_of_format(std::string_view code) {
  bool day = false, time = false, elapsed = false, percent = false;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = static_cast<char>(code[i] | 0x20);
    if (code[i] == ';') break;
    if (code[i] == '\\' || code[i] == '_' || code[i] == '*') {
      ++i;
    } else if (code[i] == '"') {
      i = code.find('"', i + 1);
      if (i == std::string_view::npos) break;
    } else if (code[i] == '[') {
      const auto close = code.find(']', i);
      if (close == std::string_view::npos) break;
      const auto inside = code.substr(i + 1, close - i - 1);
      elapsed |= !inside.empty() && inside.find_first_not_of("hHmMsS") == std::string_view::npos;
      i = close;
    } else if (code.substr(i, 7) == "General" || code[i] == 'E') {
      return CellStyle::number;
    } else {
      percent |= c == '%';
      day |= c == 'd' || c == 'y';
      time |= c == 'h' || c == 's';
    }
  }
  if (elapsed) return CellStyle::elapsed;
  if (percent) return CellStyle::percent;
  return day ? CellStyle::date : time ? CellStyle::clock : CellStyle::number;
}

CellStyle style_of_builtin(int id) {
  if (id == 9 || id == 10) return CellStyle::percent;
  if (id == 46) return CellStyle::elapsed;
  if ((id >= 18 && id <= 21) || id == 45 || id == 47 || (id >= 32 && id <= 35))
    return CellStyle::clock;
  const bool date =
      (id >= 14 && id <= 17) || id == 22 || (id >= 27 && id <= 36) || (id >= 50 && id <= 58);
  return date ? CellStyle::date : CellStyle::number;
}

std::string percent_text(double value) {
  constexpr double kPercent = 100;
  return fmt::format("{:.15g}%", value * kPercent);
}

std::string date_text(double days, CellStyle style, bool from_1904) {
  if (!(days >= 0 && days < kLastDay)) return fmt::format("{}", days);
  const auto all = std::llround(days * kMillisecondsOfDay);
  const auto whole = all / kMillisecondsOfDay + (from_1904 ? kFrom1904 : 0);
  const auto rest = all % kMillisecondsOfDay;
  if (style == CellStyle::elapsed) return day_text(whole + 61) + ' ' + clock_text(rest);
  // Counts of hours are less than two months, and a date is in this century or the last.
  if (style == CellStyle::clock && whole < kLastHours) return clock_text(all);
  return rest == 0 && style == CellStyle::date ? day_text(whole)
                                               : day_text(whole) + ' ' + clock_text(rest);
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/cells/clock_format.hpp"

#include <array>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/intake/cells/clock_cell.hpp"

namespace triax::lab {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kMinute_ns = 60 * kSecond_ns;
constexpr std::int64_t kHour_ns = 60 * kMinute_ns;
constexpr std::int64_t kDay_ns = 24 * kHour_ns;
constexpr int kFirstYear = 1899, kLastYear = 2150;
constexpr std::array<std::string_view, 4> kOrderNames{"no date", "year first", "day first",
                                                      "month first"};

/// The century of a year with two digits.
int full_year(int year) { return year + (year < 70 ? 2000 : 1900); }

std::optional<std::int64_t> day_of(const ClockFormat& format, const ClockCell& cell) {
  const bool has_name = cell.date[0].digits == 0 || cell.date[1].digits == 0;
  if (has_name != format.has_month_names || cell.date_mark != format.date_mark) return std::nullopt;
  std::array<std::size_t, 3> place{0, 1, 2};  // of the year, month, day
  if (format.order == DateOrder::day_first) place = {2, 1, 0};
  if (format.order == DateOrder::month_first) place = {2, 0, 1};
  const DatePart year = cell.date[place[0]], month = cell.date[place[1]], day = cell.date[place[2]];
  if (day.digits == 0 || day.digits > 2 || month.digits > 2 || (month.digits == 0) != has_name)
    return std::nullopt;
  int value = year.value + cell.era_years;
  if (cell.era_years == 0) {
    const bool is_short = year.digits == 1 || year.digits == 2;
    if (is_short != format.has_two_digit_year || !(is_short || year.digits == 4))
      return std::nullopt;
    if (is_short) value = full_year(value);
  }
  namespace ch = std::chrono;
  if (value < kFirstYear || value > kLastYear) return std::nullopt;
  const ch::year_month_day date{ch::year{value}, ch::month{static_cast<unsigned>(month.value)},
                                ch::day{static_cast<unsigned>(day.value)}};
  if (!date.ok()) return std::nullopt;
  return ch::sys_days{date}.time_since_epoch().count();
}

/// Hours on a clock of 24 of those with AM or PM; -1 if there are no such hours. 13:30 PM is read.
int full_hours(int hours, int half) {
  constexpr int kHalf = 12;
  if (half == 0) return hours;
  if (hours > kHalf) return half == 2 && hours < 2 * kHalf ? hours : -1;
  return hours % kHalf + (half == 2 ? kHalf : 0);
}

std::optional<std::int64_t> time_of(const ClockFormat& format, const ClockCell& cell) {
  if (format.is_half_day != (cell.half_of_day != 0) || format.has_offset != cell.has_offset)
    return std::nullopt;
  std::array<int, 3> parts = cell.time;
  const bool is_short = cell.time_parts == 2;
  if (is_short && format.is_minutes_first) parts = {0, parts[0], parts[1]};
  if (is_short && cell.has_fraction && !format.is_minutes_first) return std::nullopt;
  const bool counts_minutes = is_short && format.is_minutes_first && format.is_elapsed;
  constexpr int kMinutes = 60, kHours = 24;
  // A leap second is 60.
  if ((parts[1] >= kMinutes && !counts_minutes) || parts[2] > kMinutes) return std::nullopt;
  const int hours = full_hours(parts[0], cell.half_of_day);
  const bool ends_day = hours == kHours && parts[1] == 0 && parts[2] == 0 && cell.fraction_ns == 0;
  if (hours < 0 || (hours >= kHours && !format.is_elapsed && !ends_day)) return std::nullopt;
  const std::int64_t offset = cell.has_offset ? cell.offset_min * kMinute_ns : 0;
  return hours * kHour_ns + parts[1] * kMinute_ns + parts[2] * kSecond_ns + cell.fraction_ns -
         offset;
}

ClockTime time_of_days(const ClockCell& cell, std::int64_t day_zero) {
  return {cell.whole - day_zero, std::llround(cell.decimals * static_cast<double>(kDay_ns))};
}

/// A count since 1970, `units` of which are a second.
ClockTime time_of_count(const ClockCell& cell, std::int64_t units) {
  const std::int64_t unit_ns = kSecond_ns / units, per_day = kDay_ns / unit_ns;
  return {cell.whole / per_day, cell.whole % per_day * unit_ns +
                                    std::llround(cell.decimals * static_cast<double>(unit_ns))};
}

std::optional<ClockTime> time_of_number(ClockNumber number, const ClockCell& cell) {
  // The days 1970-01-01 of each count, and the days from then to 2150.
  constexpr std::int64_t kSpreadsheet = 25'569, kMatlab = 719'529, kJulian = 2'440'587;
  constexpr std::int64_t kMaxDays = 66'000;
  const auto days = [&](std::int64_t zero) -> std::optional<ClockTime> {
    if (cell.whole < zero - kSpreadsheet || cell.whole > zero + kMaxDays) return std::nullopt;
    return time_of_days(cell, zero);
  };
  const auto count = [&](std::int64_t units) -> std::optional<ClockTime> {
    std::optional<ClockTime> time = time_of_count(cell, units);
    if (*time->day > kMaxDays) time.reset();
    return time;
  };
  switch (number) {
    case ClockNumber::none:
      break;
    case ClockNumber::spreadsheet_days:
      return days(kSpreadsheet);
    case ClockNumber::matlab_days:
      return days(kMatlab);
    case ClockNumber::julian_days: {
      auto time = days(kJulian);
      if (time) *time->time_ns -= kDay_ns / 2;  // a Julian day begins at noon
      return time;
    }
    case ClockNumber::seconds:
      return count(1);
    case ClockNumber::milliseconds:
      return count(1'000);
    case ClockNumber::microseconds:
      return count(1'000'000);
    case ClockNumber::nanoseconds:
      return count(kSecond_ns);
    case ClockNumber::part_of_day:
      if (cell.whole > 0) return std::nullopt;
      return ClockTime{{}, time_of_days(cell, 0).time_ns};
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(DateOrder order) { return kOrderNames[static_cast<std::size_t>(order)]; }

std::optional<DateOrder> find_date_order(std::string_view text) {
  for (const auto order : {DateOrder::year_first, DateOrder::day_first, DateOrder::month_first})
    if (name(order) == text) return order;
  return std::nullopt;
}

std::optional<ClockTime> read_clock(const ClockFormat& format, std::string_view text) {
  const auto cell = scan_clock_cell(text);
  if (!cell) return std::nullopt;
  if (format.number != ClockNumber::none)
    return cell->is_number ? time_of_number(format.number, *cell) : std::nullopt;
  ClockTime out;
  if (cell->date_parts == 3) {
    if (format.order == DateOrder::none) return std::nullopt;
    out.day = day_of(format, *cell);
    if (!out.day) return std::nullopt;
  }
  if (cell->time_parts == 0) return out.day ? std::optional(out) : std::nullopt;
  out.time_ns = time_of(format, *cell);
  if (!out.time_ns || !format.has_time) return std::nullopt;
  if (cell->date_parts == 1) {  // days that passed
    constexpr int kMaxDays = 9'999;
    if (format.order != DateOrder::none || cell->date[0].value > kMaxDays) return std::nullopt;
    *out.time_ns += cell->date[0].value * kDay_ns;
  }
  return out;
}

std::optional<double> clock_seconds(const ClockFormat& format, std::string_view cell) {
  const auto time = read_clock(format, trimmed(cell));
  return time ? std::optional(Clock::seconds(*time)) : std::nullopt;
}

double Clock::seconds(const ClockTime& time) {
  const std::int64_t ns = time.time_ns.value_or(0);
  const auto whole = time.day.value_or(0) * (kDay_ns / kSecond_ns) + ns / kSecond_ns;
  return static_cast<double>(whole) +
         static_cast<double>(ns % kSecond_ns) / static_cast<double>(kSecond_ns);
}

Clock::Clock(const ClockFormat& format)
    : period_ns_(format.is_elapsed         ? 0
                 : format.is_minutes_first ? kHour_ns
                                           : kDay_ns) {}

double Clock::since_start(const ClockTime& time) {
  constexpr std::int64_t kMaxCarried_ns = 50'000 * kDay_ns;  // so that no sum overflows
  const std::int64_t time_ns = time.time_ns.value_or(0);
  if (time.day) carried_ns_ = *time.day * kDay_ns;
  std::int64_t now_ns = carried_ns_ + time_ns;
  const bool passed = !time.day && first_ns_ && period_ns_ > 0 && carried_ns_ < kMaxCarried_ns &&
                      now_ns < last_ns_ - period_ns_ / 2;
  if (passed) {
    carried_ns_ += period_ns_;
    now_ns += period_ns_;
  }
  if (!first_ns_) first_ns_ = now_ns;
  last_ns_ = now_ns;
  return static_cast<double>(now_ns - *first_ns_) / static_cast<double>(kSecond_ns);
}

std::string describe(const ClockFormat& format) {
  if (format.number != ClockNumber::none) {
    constexpr std::array<std::string_view, 9> kCounts{"",
                                                      "day counts of a spreadsheet",
                                                      "day counts of MATLAB",
                                                      "Julian days",
                                                      "seconds since 1970",
                                                      "milliseconds since 1970",
                                                      "microseconds since 1970",
                                                      "nanoseconds since 1970",
                                                      "parts of a day"};
    return std::string(kCounts[static_cast<std::size_t>(format.number)]);
  }
  const std::string_view time = !format.has_time          ? ""
                                : format.is_minutes_first ? "minutes and seconds"
                                : format.is_elapsed       ? "elapsed times"
                                : format.is_half_day      ? "times of day with AM and PM"
                                                          : "times of day";
  if (format.order == DateOrder::none) return std::string(time);
  return fmt::format("dates, {}{}{}", name(format.order), time.empty() ? "" : ", and ", time);
}

}  // namespace triax::lab

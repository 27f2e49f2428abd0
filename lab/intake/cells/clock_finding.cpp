// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/intake/cells/clock_cell.hpp"
#include "lab/intake/cells/clock_format.hpp"
#include "lab/intake/cells/fill_values.hpp"

namespace triax::lab {
namespace {

constexpr double kClearStep = 10;  ///< a step of the wrong order is longer by this factor, or more

/// The cells that can be clocks, beside the number of those that cannot.
struct ClockSample {
  std::vector<std::string_view> texts;
  std::vector<ClockCell> cells;
  std::size_t others = 0;

  std::size_t count(auto is) const {
    return static_cast<std::size_t>(std::ranges::count_if(cells, is));
  }
};

ClockSample sample_clocks(std::span<const std::string_view> cells) {
  ClockSample out;
  for (const auto cell : cells) {
    const auto text = trimmed(cell);
    if (is_fill_text(text)) continue;
    if (const auto parts = scan_clock_cell(text)) {
      out.texts.push_back(text);
      out.cells.push_back(*parts);
    } else {
      ++out.others;
    }
  }
  return out;
}

bool is_dated(const ClockCell& cell) { return cell.date_parts == 3; }
bool is_timed(const ClockCell& cell) { return cell.time_parts > 0; }

/// The count whose instants from 1973 (a day: from 1970) to 2150 have that size; none is two.
ClockNumber number_of_size(const ClockCell& cell, ClockHeading heading) {
  struct Size {
    ClockNumber number;
    double low, high;
  };
  constexpr std::array kSizes{Size{ClockNumber::spreadsheet_days, 25e3, 91e3},
                              Size{ClockNumber::matlab_days, 719e3, 785e3},
                              Size{ClockNumber::julian_days, 2440e3, 2506e3},
                              Size{ClockNumber::seconds, 1e8, 5.7e9},
                              Size{ClockNumber::milliseconds, 1e11, 5.7e12},
                              Size{ClockNumber::microseconds, 1e14, 5.7e15},
                              Size{ClockNumber::nanoseconds, 1e17, 5.7e18}};
  if (heading == ClockHeading::time_of_day && cell.whole == 0) return ClockNumber::part_of_day;
  const auto value = static_cast<double>(cell.whole);
  const auto* const found = std::ranges::find_if(
      kSizes, [&](const Size& size) { return value >= size.low && value < size.high; });
  return found == kSizes.end() ? ClockNumber::none : found->number;
}

/// One format, and what it makes of the sample.
struct ClockTrial {
  ClockFormat format;
  std::vector<bool> fits;
  std::size_t fit_count = 0;
  double max_step_s = 0;  ///< between two rows
};

ClockTrial try_format(const ClockFormat& format, const ClockSample& sample) {
  ClockTrial out{format, {}, 0, 0};
  std::optional<double> last;
  for (const auto text : sample.texts) {
    const auto time = read_clock(format, text);
    out.fits.push_back(time.has_value());
    if (!time) continue;
    ++out.fit_count;
    if (format.order != DateOrder::none && !time->day) continue;
    const double now = *clock_seconds(format, text);
    if (last) out.max_step_s = std::max(out.max_step_s, std::fabs(now - *last));
    last = now;
  }
  return out;
}

/// All but the order of the date and the digits of its year.
ClockFormat common_format(const ClockSample& sample) {
  ClockFormat out;
  const auto dated = sample.count(is_dated), timed = sample.count(is_timed);
  const auto most = [&](std::size_t of, auto is) { return 2 * sample.count(is) > of; };
  std::array<std::size_t, 256> marks{};
  for (const ClockCell& cell : sample.cells)
    if (is_dated(cell)) ++marks[static_cast<unsigned char>(cell.date_mark)];
  out.date_mark = static_cast<char>(std::ranges::max_element(marks) - marks.begin());
  out.has_month_names = most(dated, [](const ClockCell& cell) {
    return is_dated(cell) && (cell.date[0].digits == 0 || cell.date[1].digits == 0);
  });
  out.has_time = timed > 0;
  out.is_half_day = most(timed, [](const ClockCell& cell) { return cell.half_of_day != 0; });
  out.has_offset = most(timed, [](const ClockCell& cell) { return cell.has_offset; });
  out.is_minutes_first =
      most(timed, [](const ClockCell& cell) { return cell.time_parts == 2 && cell.has_fraction; });
  out.is_elapsed = dated == 0 && sample.count([&](const ClockCell& cell) {
    const bool is_short = out.is_minutes_first && cell.time_parts == 2;
    return cell.date_parts == 1 || (is_short ? cell.time[0] >= 60 : cell.time[0] > 23);
  }) > 0;
  return out;
}

/// The orders that the cells leave open, before any value is looked at.
std::vector<ClockTrial> open_trials(const ClockSample& sample, std::optional<DateOrder> order) {
  const ClockFormat common = common_format(sample);
  const auto dated = sample.count(is_dated);
  if (dated == 0) return {try_format(common, sample)};
  const bool is_year_first = 2 * sample.count([](const ClockCell& cell) {
    return cell.has_year_mark || cell.era_years != 0;
  }) > dated;
  std::vector<ClockTrial> out;
  for (const auto each : {DateOrder::year_first, DateOrder::day_first, DateOrder::month_first}) {
    if (order ? each != *order : is_year_first && each != DateOrder::year_first) continue;
    ClockFormat format = common;
    format.order = each;
    const std::size_t year = each == DateOrder::year_first ? 0 : 2;
    format.has_two_digit_year = 2 * sample.count([&](const ClockCell& cell) {
      return is_dated(cell) && cell.era_years == 0 && cell.date[year].digits < 3;
    }) > dated;
    // "26.03.10", "10-Mar-26" and "3/10/26 10:00 PM" do not begin with the year.
    const bool begins_short = each == DateOrder::year_first && format.has_two_digit_year;
    if (begins_short && !order && !is_year_first &&
        (format.date_mark == '.' || format.has_month_names || format.is_half_day))
      continue;
    out.push_back(try_format(format, sample));
  }
  return out;
}

std::string step_text(double seconds) {
  constexpr double kDay = 86'400, kHour = 3'600, kMinute = 60;
  if (seconds >= 2 * kDay) return fmt::format("{:.0f} days", seconds / kDay);
  if (seconds >= 2 * kHour) return fmt::format("{:.0f} h", seconds / kHour);
  if (seconds >= 2 * kMinute) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:g} s", seconds);
}

/// "'03/09/2026 22:00' to '03/10/2026 05:15'"
std::string ends_of(const ClockSample& sample) {
  return excerpt(sample.texts.front()) + " to " + excerpt(sample.texts.back());
}

/// True for numbers that can only be dates and times, whatever their heading is: after 2001,
/// ascending or descending, within ten years. Other quantities can have the size of a number of
/// days, so that days must be within 400, and most must have decimals.
bool are_dates(const ClockSample& sample, const ClockFormat& format) {
  constexpr double kSeconds2001 = 1e9, kTenYears_s = 3.2e8, kDays400_s = 3.5e7;
  const bool counts_days = format.number < ClockNumber::seconds;
  std::vector<double> times;
  for (const auto text : sample.texts)
    if (const auto time = clock_seconds(format, text)) times.push_back(*time);
  if (times.size() < sample.texts.size() || sample.others > 0 || times.size() < 2) return false;
  const auto [first, last] = std::ranges::minmax(times);
  if (first < kSeconds2001 || last - first > (counts_days ? kDays400_s : kTenYears_s)) return false;
  if (!std::ranges::is_sorted(times) && !std::ranges::is_sorted(times, std::greater<>()))
    return false;
  const auto with_decimals = sample.count([](const ClockCell& cell) { return cell.decimals > 0; });
  return !counts_days || 2 * with_decimals > times.size();
}

ClockFinding finding_of_numbers(const ClockSample& sample, ClockHeading heading) {
  ClockFormat format;
  format.order = DateOrder::year_first;
  format.has_time = true;
  const bool is_long = 2 * sample.count(is_timed) > sample.cells.size();
  const auto fits = [&](const ClockFormat& each) {
    return 2 * try_format(each, sample).fit_count > sample.cells.size() + sample.others;
  };
  // 8 digits are a date only below the heading of a date; 14 digits are a date anywhere.
  if ((heading == ClockHeading::date || is_long) && fits(format))
    return {format, false, ends_of(sample) + ": year first"};
  format = {};
  format.number = number_of_size(sample.cells.front(), heading);
  if (format.number == ClockNumber::none || !fits(format)) return {};
  if (heading == ClockHeading::time && !are_dates(sample, format)) return {};
  return {format, false, ends_of(sample) + ": " + describe(format)};
}

/// Why `best` and not one of the others.
std::string reason_for(const ClockTrial& best, const std::vector<ClockTrial>& trials,
                       const ClockSample& sample) {
  if (best.format.order == DateOrder::year_first || best.format.has_month_names) return {};
  for (const ClockTrial& other : trials) {
    const auto order = other.format.order;
    if (order == best.format.order || order == DateOrder::year_first) continue;
    if (other.fit_count == best.fit_count)
      return fmt::format(", because {} would make a step of {}", name(order),
                         step_text(other.max_step_s));
    const auto at = std::ranges::mismatch(best.fits, other.fits).in1 - best.fits.begin();
    return fmt::format(", because {} does not fit {}", excerpt(sample.texts[at]), name(order));
  }
  return {};
}

/// The trials that fit most cells, without those whose steps are impossibly long.
std::vector<ClockTrial> possible_trials(const std::vector<ClockTrial>& trials) {
  const auto fit_count = std::ranges::max(trials, {}, &ClockTrial::fit_count).fit_count;
  std::vector<ClockTrial> out;
  std::ranges::copy_if(trials, std::back_inserter(out),
                       [&](const ClockTrial& trial) { return trial.fit_count == fit_count; });
  const double step_s = std::ranges::min(out, {}, &ClockTrial::max_step_s).max_step_s;
  std::erase_if(out, [&](const ClockTrial& trial) {
    return trial.max_step_s > step_s && trial.max_step_s >= kClearStep * step_s;
  });
  // The first is assumed: the month comes first with AM and PM, else the day.
  const auto usual = out.front().format.is_half_day ? DateOrder::month_first : DateOrder::day_first;
  std::stable_partition(out.begin(), out.end(),
                        [&](const ClockTrial& trial) { return trial.format.order == usual; });
  return out;
}

/// Cells such as 25:30 are hours and minutes or minutes and seconds.
bool is_short_count(const ClockFormat& format, const ClockSample& sample) {
  const auto shorts = sample.count(
      [](const ClockCell& cell) { return cell.time_parts == 2 && !cell.has_fraction; });
  return format.is_elapsed && !format.is_minutes_first && 2 * shorts > sample.cells.size();
}

}  // namespace

ClockFinding find_clock_format(std::span<const std::string_view> cells, ClockHeading heading,
                               std::optional<DateOrder> order) {
  const ClockSample sample = sample_clocks(cells);
  if (sample.cells.empty() || sample.cells.size() < sample.others) return {};
  if (2 * sample.count(&ClockCell::is_number) > sample.cells.size())
    return finding_of_numbers(sample, heading);
  const auto trials = open_trials(sample, order);
  const auto possible = possible_trials(trials);
  const ClockTrial& best = possible.front();
  if (2 * best.fit_count < sample.cells.size() + sample.others) return {};
  ClockFinding out{best.format, possible.size() > 1, ends_of(sample) + ": "};
  if (is_short_count(best.format, sample)) {
    out.is_ambiguous = true;
    out.evidence += "hours:minutes or minutes:seconds";
  } else if (best.format.order == DateOrder::none) {
    out.evidence += describe(best.format);
  } else {
    for (const ClockTrial& trial : possible)
      out.evidence += fmt::format("{}{}", &trial == &best ? "" : " or ", name(trial.format.order));
    if (!out.is_ambiguous) out.evidence += reason_for(best, trials, sample);
  }
  return out;
}

}  // namespace triax::lab

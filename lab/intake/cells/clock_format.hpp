// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a column writes its dates and times of day, found from its cells.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace triax::lab {

enum class DateOrder : unsigned char { none, year_first, day_first, month_first };

/// "day first" and so on; "no date" for none.
std::string_view name(DateOrder order);
/// The order with that name; empty for any other text and for "no date".
std::optional<DateOrder> find_date_order(std::string_view text);

/// The meaning of plain numbers in a column of dates or times of day.
enum class ClockNumber : unsigned char {
  none,
  spreadsheet_days,  ///< 46090.9167: days since 1899-12-30
  matlab_days,       ///< 740051.92: days since the year 0, plus 1
  julian_days,       ///< 2461109.42
  seconds,           ///< since 1970-01-01, as the next three
  milliseconds,
  microseconds,
  nanoseconds,
  part_of_day,  ///< 0.9167, in a column of times of day
};

/// One way to write an instant. Seconds, their fraction and, in cells with a date, the time of day
/// may be missing in a cell; everything else is the same in all cells of a column.
struct ClockFormat {
  DateOrder order = DateOrder::none;  ///< of the date; none: no date
  char date_mark = 0;                 ///< first byte behind the first part; 0: 20260310
  bool has_month_names = false;
  bool has_two_digit_year = false;  ///< 70 to 99: 1970 to 1999, 00 to 69: 2000 to 2069
  bool has_time = false;            ///< cells with a time of day exist
  bool is_half_day = false;         ///< AM and PM
  bool has_offset = false;          ///< Z, +01:00, CET
  bool is_elapsed = false;          ///< counts beyond 24 h, or beyond 60 min: no clock of a day
  bool is_minutes_first = false;    ///< mm:ss.0
  ClockNumber number = ClockNumber::none;
};

/// Kind of column. Plain numbers below `time` are clocks only if nothing else has their size and
/// order: 14 digits of a date and a time of day, or an ascending or descending count after 2001,
/// within ten years (days: within 400, most with decimals).
enum class ClockHeading : unsigned char { time, date, time_of_day };

struct ClockFinding {
  std::optional<ClockFormat> format;  ///< empty: the cells are no clocks
  /// More than one meaning fits (both orders of day and month, or hours:minutes and
  /// minutes:seconds). `format` has one of them; ask.
  bool is_ambiguous = false;
  std::string evidence;  ///< "03/09/2026 to 03/10/2026: month first, because ..."
};

/// Finds the one format that fits most of the cells, which are in the order of the rows. Cells
/// without a value are skipped; the cells are no clocks if fewer than half of the others fit. Day
/// and month: an order that fits more cells is right (a number above 12); else the order whose
/// largest step between rows is smaller by a factor of 10; else the result is ambiguous. `order`
/// leaves no choice.
ClockFinding find_clock_format(std::span<const std::string_view> cells,
                               ClockHeading heading = ClockHeading::time,
                               std::optional<DateOrder> order = {});

/// An instant, or the part of it that a cell holds. Nanoseconds keep the digits of a file.
struct ClockTime {
  std::optional<std::int64_t> day;      ///< since 1970-01-01
  std::optional<std::int64_t> time_ns;  ///< since midnight, or since the count began
};

/// The trimmed cell in that format; empty if it does not fit. Days are between 1899 and 2150.
std::optional<ClockTime> read_clock(const ClockFormat& format, std::string_view text);

/// The same in s since 1970-01-01, or since midnight without a date. A date without a time of day
/// is its midnight.
std::optional<double> clock_seconds(const ClockFormat& format, std::string_view cell);

/// Makes a time of the test of the clock's times, in the order of the rows: it begins at 0. A clock
/// without a date goes on when it passes midnight, and a date holds for the cells below it that
/// have none. A clock that is set back goes back.
class Clock {
 public:
  Clock() = default;
  explicit Clock(const ClockFormat& format);
  /// s since 1970, or since midnight or the begin of the count without a date.
  static double seconds(const ClockTime& time);
  /// s since the first time. Without a time of day it is that of midnight.
  double since_start(const ClockTime& time);

 private:
  std::int64_t period_ns_ = 0;  ///< after which the clock begins again; 0: never
  std::optional<std::int64_t> first_ns_;
  std::int64_t last_ns_ = 0;
  std::int64_t carried_ns_ = 0;  ///< of the date, or of the midnights that passed
};

/// For messages: "dates with the day first and times of day".
std::string describe(const ClockFormat& format);

}  // namespace triax::lab

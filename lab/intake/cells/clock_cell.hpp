// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The numbers and words of one cell of a date or clock, before the order of its date is known.
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace triax::lab {

/// One of the three parts of a date.
struct DatePart {
  int value = 0;
  int digits = 0;  ///< 0: the name of a month
};

struct ClockCell {
  std::array<DatePart, 3> date{};  ///< in the order of the cell
  int date_parts = 0;              ///< 3: a date; 1, with a time: days that passed ("1.02:30:00")
  char date_mark = 0;              ///< first byte behind the first part; 0 for 20260310
  bool has_year_mark = false;      ///< 年 behind the first part
  int era_years = 0;               ///< to add to the year; 0: none

  int time_parts = 0;  ///< 2 or 3 numbers, as hours, minutes, seconds or minutes, seconds
  std::array<int, 3> time{};
  std::int64_t fraction_ns = 0;  ///< of a second
  bool has_fraction = false;
  int half_of_day = 0;  ///< 1: AM, 2: PM, 0: not in the cell
  bool has_offset = false;
  int offset_min = 0;  ///< ahead of UTC

  bool is_number = false;  ///< digits only, with at most one decimal mark
  std::int64_t whole = 0;  ///< of the number
  double decimals = 0;     ///< of the number, 0 to 1
};

/// The parts of a trimmed cell; empty for any text that is no date, clock or number without sign.
/// Values are not checked. Linear in the size, and nothing is read from cells above 64 bytes.
std::optional<ClockCell> scan_clock_cell(std::string_view cell);

}  // namespace triax::lab

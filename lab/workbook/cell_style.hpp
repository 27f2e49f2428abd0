// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which numbers of a workbook are dates, and what they say.
#include <string>
#include <string_view>

namespace triax::lab {

enum class CellStyle : unsigned char {
  number,
  date,     ///< day, with or without a time of day
  clock,    ///< time of day
  elapsed,  ///< hours beyond a day: [h]:mm
  percent,  ///< 0.05 is shown as 5 %
};

/// By a format as the file has it ("yyyy\-mm\-dd hh:mm:ss.000"): text in quotes, behind a
/// backslash, colours and locales in brackets say nothing. m is a month beside y or d, a minute
/// beside h or s.
CellStyle style_of_format(std::string_view code);
/// By the number of a built-in format (9, 10, 14 to 22, 27 to 36, 45 to 47, 50 to 58).
CellStyle style_of_builtin(int id);

/// "5%" of 0.05: what is shown, since the heading's unit is that of what is shown.
std::string percent_text(double value);

/// A spreadsheet's day count as lab/intake/cells/clock_format.hpp reads it: "2019-02-11
/// 06:30:24.5", "06:30:24"; a date without a time of day is "2019-02-11". A time of day beyond 24 h
/// is shown as hours ("26:15:00"). Time that passed becomes a date and time, since only differences
/// count. To the millisecond; the number itself, as text, where it is no day of 1900 to 9999.
std::string date_text(double days, CellStyle style, bool from_1904);

}  // namespace triax::lab

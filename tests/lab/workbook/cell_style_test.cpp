// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/cell_style.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("formats of dates, clocks and plain numbers") {
  CHECK(style_of_format("yyyy\\-mm\\-dd hh:mm:ss.000") == CellStyle::date);
  CHECK(style_of_format("[$-409]d/m/yy;@") == CellStyle::date);
  CHECK(style_of_format("hh:mm:ss") == CellStyle::clock);
  CHECK(style_of_format("[h]:mm:ss") == CellStyle::elapsed);
  for (const char* const number : {"General", "0.00", "0.00E+00", "0.0\" days\"", "[Red]0.0",
                                   "0.00\\ \\h", "#,##0.00;[Red]-#,##0.00 \"d\""})
    CHECK(style_of_format(number) == CellStyle::number);
  for (const char* const percent : {"0%", "0.00 %", "[Red]0.0%;-0.0%"})
    CHECK(style_of_format(percent) == CellStyle::percent);
  CHECK(style_of_format("0.0\"%\"") == CellStyle::number);
  CHECK(style_of_format("0.0\\%") == CellStyle::number);
  CHECK(style_of_builtin(9) == CellStyle::percent);
  CHECK(style_of_builtin(10) == CellStyle::percent);
  CHECK(style_of_builtin(11) == CellStyle::number);
  CHECK(style_of_builtin(14) == CellStyle::date);
  CHECK(style_of_builtin(22) == CellStyle::date);
  CHECK(style_of_builtin(21) == CellStyle::clock);
  CHECK(style_of_builtin(46) == CellStyle::elapsed);
  CHECK(style_of_builtin(4) == CellStyle::number);
}

TEST_CASE("day counts of both kinds, with the leap day of 1900 that never was") {
  CHECK(date_text(1, CellStyle::date, false) == "1900-01-01");
  CHECK(date_text(59, CellStyle::date, false) == "1900-02-28");
  CHECK(date_text(61, CellStyle::date, false) == "1900-03-01");
  CHECK(date_text(43507.5, CellStyle::date, false) == "2019-02-11 12:00:00");
  CHECK(date_text(0, CellStyle::date, true) == "1904-01-01");
  CHECK(date_text(0.5 + 1.25 / 86400, CellStyle::clock, false) == "12:00:01.250");
  CHECK(date_text(1.09375, CellStyle::clock, false) == "26:15:00");
  CHECK(date_text(43507.5, CellStyle::clock, false) == "2019-02-11 12:00:00");
  CHECK(date_text(-1, CellStyle::date, false) == "-1");
}

TEST_CASE("a share is told as it is shown, without the noise of its last digits") {
  CHECK(percent_text(0.05) == "5%");
  CHECK(percent_text(0.07) == "7%");
  CHECK(percent_text(-0.00123) == "-0.123%");
}

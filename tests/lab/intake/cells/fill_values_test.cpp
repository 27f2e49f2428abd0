// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/cells/fill_values.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <string>

using namespace triax::lab;

TEST_CASE("is_fill_text: words for no value, in any letter case", "[intake]") {
  for (const char* text :
       {"",        "-",      "--",     "---",      "?",      "NaN",      "nan",     "-nan",
        "n/a",     "N.A.",   "null",   "None",     "k.A.",   "K.A.",     "нет",     "НЕТ",
        "н/д",     "无",     "欠測",   "OVLD",     "ovld",   "OL",       "-OL",     "O.L",
        "OVRFLO",  "+OVER",  "Fehler", "ERR",      "*****",  "*",        "#####",   "#",
        "#DIV/0!", "#WERT!", "#NV",    "#VALEUR!", "#ЗНАЧ!", "#¡DIV/0!", "1.#QNAN", "-1.#IND",
        "1.#INF",  "inf",    "-Inf",   "Infinity", "<0.1",   "> 100",    "≥ 1,5",   "..."}) {
    INFO(text);
    CHECK(is_fill_text(text));
  }
}

TEST_CASE("is_fill_text: numbers, units and other words are no fill text", "[intake]") {
  for (const char* text : {"0", "-9999", "12.3*", "kPa", "overlap", "o", "x", "<", ">=", "< abc",
                           "1.", "-5", "a*", "*a", "nano", "Saturation"}) {
    INFO(text);
    CHECK_FALSE(is_fill_text(text));
  }
  CHECK_FALSE(is_fill_text(std::string(1'000'000, 'n')));
  CHECK(is_fill_text(std::string(1'000'000, '*')));
  CHECK_FALSE(is_fill_text(std::string_view("\0", 1)));
}

TEST_CASE("begins_with_comment: an error word of a spreadsheet is no comment", "[intake]") {
  CHECK(begins_with_comment("# Sample 7", "#"));
  CHECK(begins_with_comment("#Sample;7", "#"));
  CHECK(begins_with_comment("##### results", "#"));
  CHECK_FALSE(begins_with_comment("#DIV/0!;0.1;2", "#"));
  CHECK_FALSE(begins_with_comment("#N/A,0.1,2", "#"));
  CHECK_FALSE(begins_with_comment("0.1;2", "#"));
  CHECK_FALSE(begins_with_comment("0.1;2", ""));
}

TEST_CASE("is_fill_number: codes of loggers, and no other number", "[intake]") {
  for (const double code :
       {-9999.0, -999.0,   -999.25,  -999.9,  -99999.0,     9999.0,
        99999.0, 999999.0, 6999.0,   -6999.0, 7999.0,       -7999.0,
        -8888.0, -7777.0,  -32768.0, 32767.0, 65535.0,      -2147483648.0,
        1e30,    -1e30,    9.9e37,   9.91e37, 3.4028235e38, 1.7976931348623157e308}) {
    INFO(code);
    CHECK(may_be_fill_number(code));
    CHECK(is_fill_number(code));
  }
  for (const double value : {0.0, -99.0, 999.0, 999.9, 1000.0, 9990.0, 9998.0, 9999.5, 10000.0,
                             -1000.0, -999.5, 32768.0, 1e6, 2e9, 1e12}) {
    INFO(value);
    CHECK_FALSE(is_fill_number(value));
  }
}

TEST_CASE("means_no_value: a channel that passes through a code is read", "[intake]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(means_no_value(9999, none));
  CHECK(means_no_value(9999, 400));
  CHECK(means_no_value(-9999, 9999));
  CHECK_FALSE(means_no_value(9999, 9980));
  CHECK_FALSE(means_no_value(-9999, -9700));
  CHECK_FALSE(means_no_value(9998, 400));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/cell_shape.hpp"

#include <string>
#include <utility>

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// The formats in which a cell can be read, as "." and "," with the thousands mark behind.
std::string formats_of(std::string_view cell) {
  std::string out;
  const auto formats = find_shape(cell).formats;
  for (std::size_t i = 0; i < kNumberFormats.size(); ++i) {
    if (((formats >> i) & 1U) == 0) continue;
    if (!out.empty()) out += ' ';
    out += static_cast<char>(kNumberFormats[i].decimal);
    if (kNumberFormats[i].thousands != 0) out += kNumberFormats[i].thousands;
  }
  return out;
}

}  // namespace

TEST_CASE("Cell shape: a number can be read in the formats it fits") {
  const std::string any = formats_of("12");
  CHECK(any == ". , ., ,. .  ,  .' ,'");
  const std::pair<const char*, const char*> cells[] = {{"0.5", ". ., .  .'"},
                                                       {"0,5", ", ,. ,  ,'"},
                                                       {"1,234.5", ".,"},
                                                       {"1.234,5", ",."},
                                                       {"1 234,5", ", "},
                                                       {"1\u00A0234.5", ". "},
                                                       {"1'234.5", ".'"},
                                                       {"1\u2019234.5", ".'"},
                                                       {"12,34,567.8", ".,"},
                                                       {"0,123.4", ""},
                                                       {"1234,567.8", ""},
                                                       {"-1.5E-03", ". ., .  .'"},
                                                       {"1,5D+02", ", ,. ,  ,'"},
                                                       {"\u22121.5", ". ., .  .'"},
                                                       {"(12.5)", ". ., .  .'"},
                                                       {".5", ". ., .  .'"},
                                                       {"5.", ". ., .  .'"},
                                                       {"+7.5", ". ., .  .'"},
                                                       {"\uFF11\uFF12.5", ". ., .  .'"}};
  for (const auto& [cell, formats] : cells) {
    INFO(cell);
    CHECK(formats_of(cell) == formats);
  }
  CHECK(formats_of("1,234") == ", ., ,. ,  ,'");
}

TEST_CASE("Cell shape: dates and times of loggers are clocks") {
  for (const char* cell :
       {"2026-03-09", "9/3/26", "09.03.2026", "2026-03-09 23:59:50", "2026-03-09T10:00:00Z",
        "2026-03-09T10:00:00.250+01:00", "3/9/2026 11:59:45 PM", "10:00", "123:15:02", "0:00:00.5",
        "00:00:01,250", "9-Mar-2026", "9 m\u00E4rz 2026 10:00", "2026\u5E743\u67089\u65E5"}) {
    INFO(cell);
    CHECK(find_shape(cell).shape == CellShape::clock);
  }
}

TEST_CASE("Cell shape: words for missing values are fills") {
  for (const char* cell : {"NaN", "-", "--", "n/a", "OVRFLO", "OL", "#DIV/0!", "#N/A", "***",
                           "1.#QNAN", "<0.1", ">100", "k.A.", "#WERT!"}) {
    INFO(cell);
    CHECK(find_shape(cell).shape == CellShape::fill);
  }
  CHECK(find_shape("").shape == CellShape::empty);
}

TEST_CASE("Cell shape: names, units and drawn lines are no values") {
  for (const char* cell : {"sigma1", "kPa", "12 kPa", "BH-3", "1.2.3.4", "E", "-", "12:", "3/",
                           "1e", "--5", "()", "(", "2026-03-09 text", "\xFF\xFE", "\u03C31"}) {
    INFO(cell);
    const auto shape = find_shape(cell).shape;
    CHECK((shape == CellShape::text) == (std::string(cell) != "-"));
  }
  CHECK(find_shape("-----").shape == CellShape::rule);
  CHECK(find_shape("=====").shape == CellShape::rule);
}

TEST_CASE("Cell shape: long and broken cells are text") {
  CHECK(find_shape(std::string(100000, '1')).shape == CellShape::text);
  CHECK(find_shape(std::string("1\0002", 3)).shape == CellShape::text);
  CHECK(find_shape("\xEF\xBC").shape == CellShape::text);
}

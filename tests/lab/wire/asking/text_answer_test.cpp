// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/asking/text_answer.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/wire/exchange.hpp"

using namespace triax::lab;

TEST_CASE("numbers as SCPI writes them", "[asking]") {
  CHECK(spoken_number("+1.25000000E+01") == 12.5);
  CHECK(spoken_number(" -0.5 ") == -0.5);
  CHECK(spoken_number("9.9E37") == INFINITY);
  CHECK(spoken_number("-9.90000000E+37") == -INFINITY);
  CHECK(std::isnan(spoken_number("+9.91E+37")));
  for (const auto* text :
       {"", " ", "+", "++1", "+-1", "inf", "nan", "1 V", "1.2.3", "0x10", "1,2", "--1", "1e999"}) {
    INFO(text);
    CHECK_THROWS_AS(spoken_number(text), Malformed);
  }
}

TEST_CASE("lists of numbers", "[asking]") {
  CHECK(spoken_numbers("1,2;3\r\n4\n5\r\n", 5) == std::vector<double>{1, 2, 3, 4, 5});
  for (const auto* text : {"1,,2\n", "1,2,\n", ",1,2\n", "1\n\n2\n", "1 2 3\n", "\n"}) {
    INFO(text);
    CHECK_THROWS_AS(spoken_numbers(text, 3), Malformed);
  }
  CHECK_THROWS_AS(spoken_numbers("1,2,3", 2), Malformed);
  const auto open = spoken_numbers("7\r\n OPEN\r\n", 2, "OPEN");
  CHECK(open[0] == 7);
  CHECK(std::isnan(open[1]));
  CHECK_THROWS_AS(spoken_numbers("7\r\nOPEN\r\n", 2), Malformed);
  CHECK_THROWS_AS(spoken_numbers("7\r\nOPENED\r\n", 2, "OPEN"), Malformed);
}

TEST_CASE("numbers with the instants of their readings", "[asking]") {
  const auto said =
      stamped_numbers("+1.25E+00,1970,01,02,00,00,01.500,-2.5E+00,1970,01,02,00,00,02.750\n", 2);
  CHECK(said.numbers == std::vector<double>{1.25, -2.5});
  CHECK(said.first_s == 86'401.5);
  // 10 957 days to the year 2000, and 29 February counts (date -u -d 2000-03-01 +%s).
  CHECK(stamped_numbers("1,2000,03,01,00,00,00", 1).first_s == 951'868'800);
  for (const char* const wrong :
       {"1,2001,02,29,00,00,00", "1,2000,13,01,00,00,00", "1,2000,01,01,24,00,00",
        "1,2000,01,01,00,60,00", "1,2000,01,01,00,00,61.0", "1,2000.5,01,01,00,00,00",
        "1,2000,01,01,00,00", "1", "1,2000,01,01,00,00,00,2"})
    CHECK_THROWS_AS(stamped_numbers(wrong, 1), Malformed);
}

TEST_CASE("the length of some lines", "[asking]") {
  CHECK(whole_lines("a\nb\nc", 2, '\n') == 4);
  CHECK(whole_lines("a\nb", 2, '\n') == 0);
  CHECK(whole_lines("a\rb", 1, '\r') == 2);
  CHECK_THROWS_AS(whole_lines(std::string("1\0002\n", 4), 1, '\n'), Malformed);
  CHECK_THROWS_AS(whole_lines("\x1b[0m", 1, '\n'), Malformed);
  CHECK(whole_lines(std::string(1000, '1'), 1, '\n') == 0);
  CHECK_THROWS_AS(whole_lines(std::string(70000, '1'), 1, '\n'), Malformed);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/encoding_odds.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("Encoding odds: signs of units alone are Western") {
  for (const char* text : {"T (\xB0"
                           "C)\n",
                           "V (mm\xB3)\n", "p\xB4[kPa]\n", "d [\xB5m]\n", "\xA7 5\n"})
    CHECK(find_code_page(text, "") == "Windows-1252");
}

TEST_CASE("Encoding odds: repeated headings count once") {
  std::string text;
  for (int i = 0; i < 500; ++i) text += "Volume " + std::to_string(i) + " (mm\xB3);";
  CHECK(find_code_page(text + "\n", "") == "Windows-1252");
}

TEST_CASE("Encoding odds: signs of another language do not mislead") {
  CHECK(find_code_page("\xCE\xC2\xB6\xC8(\xA1\xE6)\n", "") == "GB18030");  // 温度(℃)
  CHECK(find_code_page("\xC4\xE0\xE2\xEB\xE5\xED\xE8\xE5 (\xEA\xCF\xE0)\n", "") ==
        "Windows-1251");  // Давление (кПа)
  CHECK(find_code_page("\xB5\xCC\xBE\xAF\xC4,\x89\xD7\x8F\x64\n", "") ==
        "Shift-JIS");  // Katakana of half width
}

TEST_CASE("Encoding odds: lines that are cut between the parts do not count") {
  CHECK(find_code_page("\xCA\xB1\xBC\xE4\n1,2,\xCA", "\xB1\n\xBF\xD7\xD1\xB9\n") == "GB18030");
  CHECK(find_code_page("\xFF\xFE\x80", "\xFF") != "");
}

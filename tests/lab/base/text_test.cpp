// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/text.hpp"

#include <catch2/catch.hpp>
#include <cstdint>

using namespace triax::lab;

TEST_CASE("UTF-8 is told from what only looks like it") {
  CHECK(is_utf8("abc"));
  CHECK(is_utf8("mm³ °C σ 𝜎"));
  CHECK_FALSE(is_utf8("mm\xB3"));            // cp1252
  CHECK_FALSE(is_utf8("\xC0\xAF"));          // overlong
  CHECK_FALSE(is_utf8("\xED\xA0\x80"));      // surrogate
  CHECK_FALSE(is_utf8("\xF4\x90\x80\x80"));  // beyond the last character
  CHECK_FALSE(is_utf8("\xE2\x82"));          // cut
}

TEST_CASE("Windows-1252 becomes UTF-8") {
  CHECK(utf8_from_cp1252("mm\xB3 \xB0"
                         "C \x80 \x96") == "mm³ °C € –");
  CHECK(utf8_from_cp1252("\x81") == "\xEF\xBF\xBD");
  for (int byte = 1; byte < 256; ++byte)
    CHECK(is_utf8(utf8_from_cp1252(std::string(1, static_cast<char>(byte)))));
}

TEST_CASE("names are compared without case and without the blanks that do not matter") {
  CHECK(trimmed(" \t a b \xC2\xA0\r") == "a b");
  CHECK(trimmed("   ").empty());
  CHECK(folded("  Axial   STRAIN ") == "axial strain");
}

TEST_CASE("an excerpt is short, printable UTF-8") {
  CHECK(excerpt("abc") == "'abc'");
  CHECK(excerpt("a\x01\nb") == "'a??b'");
  CHECK(excerpt("mm\xB3") == "'mm³'");
  CHECK(excerpt("a\xC2\xAD"
                "b\xC2\xA0"
                "c\xE2\x80\x8B"
                "d") == "'a?b?c?d'");
  const auto cut = excerpt(std::string(500, 'x'));
  CHECK(cut == "'" + std::string(40, 'x') + "...'");
  std::string greek;
  for (int i = 0; i < 50; ++i) greek += "xσ";
  CHECK(is_utf8(excerpt(greek)));
}

TEST_CASE("a text is a number only if nothing of it is left over") {
  CHECK(whole_text_as<int>("-12") == -12);
  CHECK(whole_text_as<std::int64_t>("9223372036854775807") == 9223372036854775807);
  CHECK(whole_text_as<double>("1.5e-3") == 1.5e-3);
  for (const char* text : {"", " 1", "1 ", "+1", "1x", "1,5", "0x10", "x"}) {
    INFO(text);
    CHECK_FALSE(whole_text_as<std::int64_t>(text));
    CHECK_FALSE(whole_text_as<double>(text));
  }
  CHECK_FALSE(whole_text_as<std::int64_t>("1.0"));
  CHECK_FALSE(whole_text_as<std::int64_t>("9223372036854775808"));
  CHECK_FALSE(whole_text_as<std::uint64_t>("-1"));
  CHECK_FALSE(whole_text_as<double>("1e999"));
}

TEST_CASE("the nearest key is the one with the fewest typing errors") {
  CHECK(nearest("hieght_mm", {"diameter_mm", "height_mm", "void_ratio"}) == "height_mm");
  CHECK(nearest("DIAMETER", {"height_mm", "diameter_mm"}) == "diameter_mm");
  CHECK(nearest("axial_strain", {"time_s", "axial_strain_pct"}) == "axial_strain_pct");
  CHECK(nearest("x", {}).empty());
}

TEST_CASE("what is far from every key is not taken for any of them") {
  CHECK(nearest("xyz", {"cell_pressure", "back_pressure"}).empty());
  CHECK(nearest("Bemerkung", {"time_s", "stage"}).empty());
  CHECK(nearest(std::string(1000, 'c'), {"cell_pressure"}).empty());
  CHECK(suggestion("xyz", {"a", "b"}) == "must be one of: a, b");
  CHECK(suggestion("stgae", {"time_s", "stage"}) ==
        "did you mean 'stage'? (must be one of: time_s, stage)");
  CHECK(joined({"a", "", "b"}) == "a, b");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/wrapping.hpp"

#include <catch2/catch.hpp>

using namespace triax::src;
using Lines = std::vector<std::string>;

TEST_CASE("text is broken at blanks only, by columns of the terminal") {
  CHECK(wrapped("one two three", 7) == Lines{"one two", "three"});
  CHECK(wrapped("φφφ φφφ φφφ", 7) == Lines{"φφφ φφφ", "φφφ"});
  CHECK(wrapped("a very-long-word b", 4) == Lines{"a", "very-long-word", "b"});
  CHECK(wrapped("first\nsecond line", 8) == Lines{"first", "second", "line"});
  CHECK(wrapped("as  it   is", 80) == Lines{"as  it   is"});
  CHECK(wrapped("", 10) == Lines{""});
  CHECK(longest_word("σ₃ three") == 5);
  CHECK(longest_word("") == 0);
}

TEST_CASE("a number stays with its symbol and its unit") {
  CHECK(wrapped("at reading 12, ε₁ 0.40 % and on", 12) ==
        Lines{"at", "reading 12,", "ε₁ 0.40 %", "and on"});
  CHECK(wrapped("12, 13, 14, 15", 7) == Lines{"12, 13,", "14, 15"});
  CHECK(longest_word("q of -0.08 kPa over") == 12);
}

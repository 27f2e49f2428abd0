// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/pattern.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
using Match = ScpiPattern::Match;

namespace {
Match matched(const char* pattern, std::string_view header) {
  std::vector<int> suffixes;
  return ScpiPattern(pattern).match(header, suffixes);
}
std::vector<int> suffixes_of(const char* pattern, std::string_view header) {
  std::vector<int> suffixes;
  CHECK(ScpiPattern(pattern).match(header, suffixes) == Match::yes);
  return suffixes;
}
}  // namespace

TEST_CASE("a header is known in its short and its long form, in any case, and in no other") {
  const char* pattern = "[SOURce]:PRESsure:TARGet?";
  for (const char* header : {"SOUR:PRES:TARG?", "source:pressure:target?", "PRES:TARG?",
                             "Pressure:Targ?", "SOURCE:PRES:TARGET?"})
    CHECK(matched(pattern, header) == Match::yes);
  for (const char* header :
       {"SOUR:PRES:TARG", "SOUR:PRESS:TARG?", "SOUR:TARG?", "PRES?", "?", "", "PRES:TARG:X?",
        "SOUR::PRES:TARG?", "SOU:PRES:TARG?", "PRES:TARG??", "SOUR:SOUR:PRES:TARG?"})
    CHECK(matched(pattern, header) == Match::no);
  CHECK(matched("SYSTem:ERRor[:NEXT]?", "SYST:ERR?") == Match::yes);
  CHECK(matched("SYSTem:ERRor[:NEXT]?", "SYST:ERR:NEXT?") == Match::yes);
  CHECK(matched("*IDN?", "*idn?") == Match::yes);
  CHECK(matched("*IDN?", "IDN?") == Match::no);
}

TEST_CASE("a number in a header is known where the pattern has its mark") {
  CHECK(suffixes_of("CHANnel#:RATE#?", "CHAN3:RATE?") == std::vector{3, 1});
  CHECK(suffixes_of("[CHANnel#:]RATE?", "RATE?") == std::vector{1});
  CHECK(suffixes_of("[CHANnel#:]RATE?", "channel12:RATE?") == std::vector{12});
  CHECK(suffixes_of("RATE?", "RATE?").empty());
  CHECK(matched("PRESsure:TARGet", "PRES2:TARG") == Match::wrong_suffix);
  CHECK(matched("CHANnel#", "CHAN99999999999") == Match::wrong_suffix);
  CHECK(matched("PRESsure:TARGet", "PRES2:TARGE") == Match::no);
}

TEST_CASE("a pattern can be said in its forms") {
  const ScpiPattern pattern("[SOURce:]PRESsure:TARGet?");
  CHECK(pattern.shortest() == "PRES:TARG?");
  CHECK(pattern.longest() == "SOURce:PRESsure:TARGet?");
  CHECK(pattern.is_query());
  CHECK_FALSE(ScpiPattern("*RST").is_query());
}

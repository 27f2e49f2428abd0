// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/findings.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("findings of one kind become one warning with the first line and a count") {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  findings.note("missing", 4, "no value");
  findings.note("other", 5, "something else");
  int made = 0;
  for (const int line : {6, 9})
    findings.note("missing", line, [&] {
      ++made;
      return std::string("never");
    });
  CHECK(made == 0);
  findings.finish();
  findings.finish();
  REQUIRE(warnings.size() == 2);
  CHECK(warnings[0].line == 4);
  CHECK(warnings[0].text == "no value (and 2 more, the last in line 9)");
  CHECK(warnings[1].text == "something else");
}

TEST_CASE("a hostile file cannot make endless warnings") {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  for (int i = 0; i < 10'000; ++i) findings.note(std::to_string(i), i, "text");
  findings.finish();
  CHECK(warnings.size() == 200);
  CHECK_THAT(warnings.back().text, Catch::Contains("9800 more"));
}

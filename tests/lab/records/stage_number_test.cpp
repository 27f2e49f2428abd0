// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_number.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;
using Catch::Matchers::Contains;

TEST_CASE("stages are whole numbers, tenths become tens with a finding") {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  StageNumbers stages("r.csv");
  CHECK(stages.of(3, 7, findings) == 3);
  CHECK(warnings.empty());
  CHECK(stages.of(4.1, 8, findings) == 41);
  CHECK(stages.of(4.1, 9, findings) == 41);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].line == 8);
  for (const double value : {-1.0, 4.15, 2e6})
    CHECK_THROWS_WITH(stages.of(value, 10, findings), Contains("r.csv:10: "));
}

TEST_CASE("two stages of a file never become one") {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  StageNumbers late("r.csv"), early("r.csv");
  late.of(4.1, 8, findings);
  CHECK_THROWS_WITH(late.of(41, 9, findings), Contains("r.csv:9: stage 41") && Contains("4.1"));
  early.of(41, 8, findings);
  CHECK_THROWS_AS(early.of(4.1, 9, findings), BadInput);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/back_pressure_check.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

std::vector<Warning> warnings_of(double back_pa, double cell_pa, Drainage drainage,
                                 bool begins_stage) {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  Reading reading;
  reading[Quantity::back_pressure] = back_pa;
  reading[Quantity::cell_pressure] = cell_pa;
  reading.line = 7;
  StageInfo stage;
  stage.drainage = drainage;
  check_back_pressure(reading, &stage, begins_stage, findings);
  return warnings;
}

}  // namespace

TEST_CASE("check_back_pressure: a back pressure above the cell pressure is noted") {
  const auto found = warnings_of(300e6, 400e3, Drainage::closed, true);
  REQUIRE(found.size() == 1);
  CHECK(found[0].line == 7);
  CHECK_THAT(found[0].text, Catch::Contains("300000 kPa, is above the cell pressure, 400 kPa"));
  CHECK(warnings_of(450e3, 400e3, Drainage::open, false).size() == 1);
}

TEST_CASE("check_back_pressure: transducers may differ by their error") {
  CHECK(warnings_of(403e3, 400e3, Drainage::open, true).empty());
  CHECK(warnings_of(kMissing, 400e3, Drainage::open, true).empty());
}

TEST_CASE("check_back_pressure: a controller behind a closed valve may be at any pressure") {
  CHECK(warnings_of(450e3, 400e3, Drainage::closed, false).empty());
}

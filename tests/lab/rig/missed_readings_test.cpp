// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/missed_readings.hpp"

#include <catch2/catch.hpp>

using Catch::Contains;
using triax::lab::MissedReadings;

TEST_CASE("MissedReadings::add: reports a gap once, with both ends", "[rig]") {
  MissedReadings missed;
  CHECK_FALSE(missed.add(5, 5.9, 1));
  CHECK_THAT(missed.add(6, 9.25, 1).value_or(""), Contains("missed from 6 s to 9.25 s"));
  CHECK_FALSE(missed.add(10, 10.1, 1));
  CHECK_THAT(missed.add(11, 12, 1).value_or(""), Contains("missed from 11 s to 12 s"));
}

TEST_CASE("MissedReadings::add: reports the end of several gaps in a row", "[rig]") {
  MissedReadings missed;
  CHECK(missed.add(1, 3.5, 1));
  CHECK(missed.add(4, 6.5, 1).value_or("") == "readings are missed repeatedly from 4 s on");
  CHECK_FALSE(missed.add(7, 9.5, 1));
  CHECK(missed.add(10, 10, 1).value_or("") == "readings are on time again from 10 s on");
  CHECK_FALSE(missed.add(11, 11, 1));
}

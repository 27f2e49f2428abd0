// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/clock_time.hpp"

#include <catch2/catch.hpp>

using triax::lab::Clock;
using triax::lab::clock_seconds;

TEST_CASE("a clock's time in seconds, with and without a date") {
  CHECK(*clock_seconds("06:30:24") == 23424);
  CHECK(*clock_seconds(" 6:30 ") == 23400);
  CHECK(*clock_seconds("23:59:59.5") == 86399.5);
  CHECK(*clock_seconds("1970-01-02 00:00:01") == 86401);
  CHECK(*clock_seconds("2019-02-11T06:30:24") == 1549866624);  // date -u -d ... +%s
  CHECK(*clock_seconds("11.02.2019 06:30:24") == 1549866624);
  CHECK(*clock_seconds("11/02/2019  06:30:24") == 1549866624);
}

TEST_CASE("what no clock shows is no time") {
  for (const char* text : {"", "12", "12.5", "24:00:00", "12:60:00", "12:30:99", "a:b:c", ":30",
                           "2019-02-30 06:30:24", "11.02.2019", "123:00:00", "-1:00:00", "1:2:3:4"})
    CHECK_FALSE(clock_seconds(text));
}

TEST_CASE("a test's time begins at 0 and goes on past midnight") {
  Clock clock;
  CHECK(clock.since_start(*clock_seconds("23:59:00")) == 0);
  CHECK(clock.since_start(*clock_seconds("23:59:30")) == 30);
  CHECK(clock.since_start(*clock_seconds("00:00:10")) == 70);
  CHECK(clock.since_start(*clock_seconds("12:00:00")) == 43260);
  Clock dated;
  CHECK(dated.since_start(*clock_seconds("2019-02-11 23:59:00")) == 0);
  CHECK(dated.since_start(*clock_seconds("2019-02-13 00:00:00")) == 86460);
}

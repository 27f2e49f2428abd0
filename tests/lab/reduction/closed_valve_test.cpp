// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/closed_valve.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;
using triax::lab::testing::reading;

TEST_CASE("the volume's largest departure from the start of the stage, over the specimen's") {
  ClosedValve valve;
  for (int i = 0; i < 100; ++i) valve.add(reading({3, 0, 0, 400, 300, 70.0 - i}, i), true, 1e-6);
  const auto check = valve.check();
  REQUIRE(check);
  CHECK(*check->measured == Approx(99e-9 / 1e-6));
  CHECK_FALSE(check->ok);
  CHECK(check->note.find("99 mm3 flowed from the specimen by reading 99") != std::string::npos);
}

TEST_CASE("a volume that stands still passes, wherever its counter stands") {
  ClosedValve valve;
  for (int i = 0; i < 100; ++i) valve.add(reading({3, 0, 0, 400, 300, 5e4 + i % 2}, i), true, 5e-4);
  CHECK(valve.check()->ok);
  CHECK(*valve.check()->measured == Approx(1e-9 / 5e-4));
}

TEST_CASE("each stage counts from its own start; drained shear says nothing") {
  ClosedValve valve;
  for (int i = 0; i < 100; ++i)
    valve.add(reading({3 + i / 50, 0, 0, 400, 300, i < 50 ? 0.0 : 900.0}, i), true, 5e-4);
  CHECK(*valve.check()->measured == Approx(0));
  ClosedValve drained;
  drained.add(reading({3, 0, 0, 400, 300, 9}), false, 5e-4);
  CHECK_FALSE(drained.check());
}

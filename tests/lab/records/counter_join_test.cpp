// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/counter_join.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
using enum Quantity;

namespace {
struct Join {
  std::vector<Warning> warnings;
  Findings findings{warnings};
  CounterJoin counters;
  double pass(Quantity quantity, double value, int stage, bool begins) {
    std::array<double, kQuantityCount> si;
    si.fill(kMissing);
    si[index(quantity)] = value;
    counters.apply(si, stage, begins, 7, findings);
    return si[index(quantity)];
  }
};
}  // namespace

TEST_CASE("a counter set to zero between stages is joined, and the size of the jump is said") {
  Join join;
  CHECK(join.pass(back_volume, 8058e-9, 4, true) == 8058e-9);
  CHECK_FALSE(join.counters.joined(back_volume));
  CHECK(join.pass(back_volume, 0, 5, true) == 8058e-9);
  CHECK(join.pass(back_volume, 10e-9, 5, false) == Approx(8068e-9));
  REQUIRE(join.warnings.size() == 1);
  CHECK(join.counters.joined(back_volume));
  CHECK_FALSE(join.counters.joined(axial_displacement));
  CHECK(join.warnings[0].line == 7);
  CHECK_THAT(join.warnings[0].text, Catch::Contains("from 8058 to 0 mm3 at the start of stage 5"));
}

TEST_CASE("resets add up over stages") {
  Join join;
  join.pass(axial_displacement, 1e-3, 1, true);
  CHECK(join.pass(axial_displacement, 0, 2, true) == Approx(1e-3));
  join.pass(axial_displacement, 2e-3, 2, false);
  CHECK(join.pass(axial_displacement, 0, 3, true) == Approx(3e-3));
}

TEST_CASE("what moves inside a stage, drifts or goes on is left alone") {
  Join join;
  join.pass(back_volume, 5000e-9, 1, true);
  CHECK(join.pass(back_volume, 0, 1, false) == 0);
  join.pass(back_volume, 15e-9, 1, false);
  CHECK(join.pass(back_volume, 0, 2, true) == 0);
  join.pass(back_volume, 5000e-9, 2, false);
  CHECK(join.pass(back_volume, 4900e-9, 3, true) == 4900e-9);
  CHECK(join.warnings.empty());
}

TEST_CASE("a load cell set to zero is reported but keeps its reading") {
  Join join;
  join.pass(axial_force, -14, 4, true);
  CHECK(join.pass(axial_force, 1, 5, true) == 1);
  CHECK(join.warnings.size() == 1);
  CHECK_FALSE(join.counters.joined(axial_force));
}

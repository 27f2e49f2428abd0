// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/runaway_balance.hpp"

#include <catch2/catch.hpp>

using namespace triax;
using namespace triax::study;

namespace {

const lab::RunAwayTruth kArrested{3.5,   12.3e-3, 3.7,  2e-6,
                                  -4e-6, 0.99,    3.75, lab::RunAwayEnd::new_equilibrium};

}  // namespace

TEST_CASE("the ratio of Eq. (5) is 1 where twice the kinetic energy is minus the work") {
  CHECK(*balance_of(kArrested).half_work_j == Approx(2e-6));
  CHECK(*balance_of(kArrested).ratio == Approx(1));
  lab::RunAwayTruth limit_point = kArrested;
  limit_point.kinetic_energy_j = 2. / 3 * 2e-6;
  CHECK(*balance_of(limit_point).ratio == Approx(2. / 3));
  limit_point.second_order_work_j = 0;
  CHECK_FALSE(balance_of(limit_point).ratio);
  CHECK(balance_of(limit_point).half_work_j);
  limit_point.second_order_work_j.reset();
  CHECK_FALSE(balance_of(limit_point).ratio);
  CHECK_FALSE(balance_of(limit_point).half_work_j);
}

TEST_CASE("where a runaway began is told by the ratio that is expected of it") {
  lab::RunAwayTruth runaway = kArrested;
  CHECK(balance_of(runaway).start == RunawayStart::past_peak);
  runaway.expected_ratio = 0.67;
  CHECK(balance_of(runaway).start == RunawayStart::limit_point);
  runaway.expected_ratio.reset();
  CHECK_FALSE(balance_of(runaway).start);
}

TEST_CASE("a runaway lasts from its start to its end, if it has one") {
  CHECK(balance_of(kArrested).rise_s == Approx(0.2));
  CHECK(*balance_of(kArrested).duration_s == Approx(0.25));
  lab::RunAwayTruth runaway = kArrested;
  runaway.end_s.reset();
  CHECK_FALSE(balance_of(runaway).duration_s);
}

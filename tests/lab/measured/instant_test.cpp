// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/instant.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("what a state does not know is empty in its instant, never 0") {
  State state;
  state.reading = 7;
  state.time_s = 3.5;
  state.q = 40e3;
  const Instant with = instant_of(state, true);
  CHECK(with.reading == 7);
  CHECK(with.time_s == 3.5);
  CHECK(with.q_pa == 40e3);
  CHECK_FALSE(with.p_eff_pa);
  CHECK_FALSE(with.axial_strain);
  CHECK_FALSE(with.pore_pressure_pa);
  CHECK_FALSE(instant_of(state, false).time_s);
}

TEST_CASE("a point between readings belongs to the nearest; without time its progress is none") {
  PathPoint point;
  point.reading = 12.6;
  point.progress = 25.2;
  point.axial_strain = 0.004;
  CHECK(instant_of(point, true).reading == 13);
  CHECK(instant_of(point, true).time_s == 25.2);
  CHECK(instant_of(point, true).axial_strain == 0.004);
  CHECK_FALSE(instant_of(point, false).time_s);
}

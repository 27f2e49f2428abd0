// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/state.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("a new state knows nothing; eta and the mobilised angle follow from q and p'") {
  State state;
  CHECK(std::isnan(state.q));
  CHECK(std::isnan(state.eta()));
  CHECK(std::isnan(state.phi_mob_rad()));
  state.q = 60e3;
  state.p_eff = 100e3;
  CHECK(state.eta() == Approx(0.6));
  CHECK(std::sin(state.phi_mob_rad()) == Approx(3 * 0.6 / 6.6));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <vector>

#include "lab/health/judged_states.hpp"
#include "tests/lab/health/noisy_states.hpp"

using namespace triax::lab;
using triax::lab::testing::noisy;
using triax::lab::testing::raw_header;
using triax::lab::testing::state_of;

TEST_CASE("JudgedStates: an impossible state is left out, many end the assessment", "[health]") {
  for (const std::int64_t count : {1, 5, 40}) {
    JudgedStates states(raw_header());
    std::vector<bool> live;
    for (std::int64_t i = 0; i < 200; ++i) {
      const Reading r = noisy(i);
      State s = state_of(r);
      if (i >= 100 && i < 100 + count) s.p_eff = -6628e3;
      if (i >= 140) s.q = 150e3;
      CHECK(states.is_possible(s) == (s.p_eff > 0));
      states.add(r, s);
      while (const auto* judged = states.next()) {
        live.push_back(judged->live);
        if (judged->state.p_eff < 0) CHECK_FALSE(judged->axis_live);
      }
    }
    states.finish();
    while (const auto* judged = states.next()) live.push_back(judged->live);
    INFO(count << " impossible states");
    REQUIRE(live.size() == 200);
    for (std::size_t i = 0; i < 200; ++i)
      CHECK(live[i] == (i < 100 || (i >= std::size_t(100 + count) && count < 40)));
    Collapse collapse;
    states.bound(collapse);
    CHECK(collapse.judged_until == (count < 40 ? std::optional<std::int64_t>() : 99));
    CHECK_FALSE(states.trusts_axis());
    CHECK_THAT(states.warnings().at(0).text, Catch::Contains("-6628.0 kPa at reading 100"));
  }
}

TEST_CASE("JudgedStates: no onset where p' is not above zero", "[health]") {
  JudgedStates states(raw_header());
  for (const double p_eff : {10e3, -2e3}) {
    Collapse collapse;
    collapse.kind = CollapseKind::flow;
    collapse.onset.emplace();
    collapse.onset->p_eff_pa = p_eff;
    states.bound(collapse);
    CHECK(collapse.judged == (p_eff > 0));
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_cones.hpp"

#include <catch2/catch.hpp>

#include "tests/src/sample_domain.hpp"

using namespace triax;

TEST_CASE("the picture of a domain's cones: its states, its boundaries, and tests on top") {
  const auto domain = study::sample_domain();
  study::TestedState test{.id = 7, .name = "CSU 27", .origin = lab::Origin::simulated};
  test.state.p_eff = 100e3;
  test.state.q = 60e3;
  test.increment = lab::MeasuredIncrement{.angle = 3.8};
  const auto picture = study::cones_picture(domain, {test, study::TestedState{.name = "unknown"}});
  // Stable and unstable states only, every one of so few.
  std::size_t shown = 0;
  for (const auto& column : domain.columns)
    for (const auto& state : column.states)
      shown += state.kind == sim::DomainStateKind::stable ||
               state.kind == sim::DomainStateKind::unstable;
  CHECK(picture.states.size() == shown);
  REQUIRE(picture.instability_lines.size() == 2);
  REQUIRE(picture.instability_lines[0].size() == 3);
  CHECK(picture.instability_lines[0][1].p == domain.columns[1].p_eff_kPa * 1e3);
  CHECK(picture.instability_lines[0][1].q ==
        domain.columns[1].compression.isotropic_unloading->q_kPa * 1e3);
  REQUIRE(picture.tests.size() == 1);
  CHECK(picture.tests[0].name == "CSU 27");
  CHECK(picture.tests[0].state.q == 60e3);
  CHECK(picture.tests[0].simulated);
}

TEST_CASE("of a fine grid no more fans are shown than can be read, the last row among them") {
  auto domain = study::sample_domain({1});
  auto& states = domain.columns[0].states;
  const auto state = states.front();
  states.assign(100, state);
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i].kind = sim::DomainStateKind::stable;
    states[i].q_kPa = static_cast<double>(i);
  }
  const auto picture = study::cones_picture(domain, {});
  CHECK(static_cast<int>(picture.states.size()) <= study::kMostFans);
  CHECK(static_cast<int>(picture.states.size()) > study::kMostFans / 2);
  CHECK(picture.states.back().state.q == 99e3);
}

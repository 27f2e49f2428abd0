// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/stress_path.hpp"

#include <catch2/catch.hpp>

#include "src/study/triaxial/test_result.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::study;
namespace sample = triax::src::test;

TEST_CASE("a stress path has what came before shear apart from shear") {
  auto test = sample::flow_test();
  test.stored.header.stages.push_back(
      {.number = 2, .name = "c", .role = lab::StageRole::consolidation});
  for (std::size_t i = 0; i < 3; ++i) test.curves.states[i].stage = 2;
  const auto path = stress_path(test);
  CHECK(path.test == "L<oose> 1");
  REQUIRE(path.before.size() == 3);
  CHECK(path.before.front().p_eff == 140e3);
  CHECK(path.before.front().q == 0);
  CHECK(path.shear.size() == test.curves.states.size() - 3);
  CHECK(path.origin.tests == 1);
}

TEST_CASE("onset, failure and true onset are where they are known") {
  const auto collapsed = stress_path(sample::simulated_test());
  REQUIRE(collapsed.onset);
  CHECK(collapsed.onset->p_pa == 200e3);
  CHECK(collapsed.onset->eta() == 0.55);
  CHECK(collapsed.true_onset->p_pa == 100.2e3);
  CHECK(collapsed.limit_stress_ratio == 1.25);
  CHECK_FALSE(collapsed.failure);

  auto failed = sample::flow_test();
  failed.stored.summary.collapse.kind = lab::CollapseKind::none;
  const auto surface = stress_path(failed);
  CHECK_FALSE(surface.onset);
  CHECK(surface.failure->q_pa == 60e3);
  CHECK_FALSE(surface.true_onset);

  const auto stable = stress_path(sample::stable_test());
  CHECK_FALSE(stable.onset);
  CHECK_FALSE(stable.failure);
}

TEST_CASE("stress_path: the loss of control is where it is known", "[study]") {
  auto test = sample::flow_test();
  CHECK_FALSE(stress_path(test).loss_of_control);
  test.stored.summary.collapse.loss_of_control = lab::Instant{.q_pa = 50e3, .p_eff_pa = 80e3};
  REQUIRE(stress_path(test).loss_of_control);
  CHECK(stress_path(test).loss_of_control->p_pa == 80e3);
}

TEST_CASE("an instant without a stress ratio has no place on a stress path") {
  lab::Instant instant;
  CHECK_FALSE(stress_at(std::nullopt));
  instant.q_pa = 50e3;
  CHECK_FALSE(stress_at(instant));
  instant.p_eff_pa = 0;
  CHECK_FALSE(stress_at(instant));
  instant.p_eff_pa = 100e3;
  CHECK(stress_at(instant)->eta() == 0.5);
}

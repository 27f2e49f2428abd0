// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/sphere.hpp"

#include <catch2/catch.hpp>

#include "tests/src/sample_probes.hpp"

using namespace triax;

namespace {

study::SphereResult inl2_sphere_at(double eta, const study::SphereProbing& probing) {
  const auto request = src::test::inl2_request({eta});
  return study::run_sphere(
      {.material = request.material, .states = request.states, .probing = probing});
}

}  // namespace

TEST_CASE("an increment of space has the norm asked for, be it of stress or of strain") {
  const study::SphereProbing of_stress{.norm = 2e3, .rings = 6},
      of_strain{.kind = sim::ProbeKind::strain, .norm = 1e-5, .rings = 6};
  for (const auto& probing : {of_stress, of_strain}) {
    const bool stress = probing.kind == sim::ProbeKind::stress;
    const auto result = inl2_sphere_at(0.6, probing);
    REQUIRE(result.states.size() == 1);
    CHECK(result.any_answer());
    CHECK(result.states[0].sphere.probes.size() == 72);
    for (const auto& probe : result.states[0].sphere.probes) {
      if (!probe.answered) continue;
      const auto increment = study::increment_of(probe, probing);
      CHECK((stress ? increment.stress : increment.strain).norm() == Approx(probing.norm));
      CHECK(increment.second_order_work == Approx(increment.stress.dot(increment.strain)));
      CHECK((increment.second_order_work < 0) == (probe.normalised < 0));
    }
  }
  CHECK(of_stress.step_deg() == 30);
}

TEST_CASE("the own increment of a test is probed in space, axes 2 and 3 alike") {
  const auto request = src::test::inl2_request({0.6});
  auto what = study::states_to_probe<sim::Tensor>(request.material, request.states).states.at(0);
  what.test = study::TestedState{};
  what.test->increment = lab::MeasuredIncrement{.angle = 4.0};
  const auto probed = study::probe_sphere_of(request.material, what, {.rings = 6});
  REQUIRE(probed.own);
  CHECK(probed.own->direction(0) == Approx(std::sin(4.0)));
  CHECK(probed.own->direction(1) == probed.own->direction(2));
  CHECK(probed.own->normalised < 0);
}

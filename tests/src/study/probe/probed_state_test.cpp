// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/probed_state.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "sim/law/law.hpp"
#include "sim/point/point_driver.hpp"

using namespace triax;
using sim::Axisymmetric;
using sim::Tensor;

namespace {

template <class Space>
study::StateToProbe<Space> loose(const lab::MaterialSet& set, double p_kPa, double eta) {
  const double p = 1e3 * p_kPa, q = eta * p;
  const auto stress = sim::components(sim::AxisymmetricStress{p + 2 * q / 3, p - q / 3});
  study::StateToProbe<Space> what;
  if constexpr (Space::kSize == 2)
    what.state = set.material.axisymmetric->start(stress, 1.086);
  else
    what.state = set.material.tensor->start(sim::as_tensor(stress), 1.086);
  return what;
}

study::ProbedState inl2_at(double eta, const study::Probing& probing = {}) {
  const auto set = lab::find_material("inl2/S28-general");
  return study::probe_state(set, loose<Axisymmetric>(set, 70, eta), probing);
}

}  // namespace

TEST_CASE("INL2, e = 1.086, p' = 70 kPa: cones as constitutive.md prints them on half a degree") {
  const study::Probing probing{.directions = 720};
  CHECK(inl2_at(0.55, probing).circle.cones.empty());
  struct Printed {
    double eta, first, last;
  };
  for (const auto& [eta, first, last] :
       {Printed{0.6, 215, 237.5}, Printed{0.7, 208, 248.5}, Printed{0.8, 205.5, 255.5}}) {
    const auto cones = inl2_at(eta, probing).circle.cones;
    REQUIRE(cones.size() == 1);
    CHECK(std::ceil(2 * sim::degrees(cones[0].from)) / 2 == first);
    CHECK(std::floor(2 * sim::degrees(cones[0].to)) / 2 == last);
  }
}

TEST_CASE("isotropic unloading is in the cone at 0.60 and not before") {
  CHECK(inl2_at(0.55).isotropic_unloading.normalised > 0);
  const auto state = inl2_at(0.6);
  CHECK(state.isotropic_unloading.normalised < 0);
  CHECK(state.circle.cones.at(0).contains(state.isotropic_unloading.angle));
  // dq = 0, dp' < 0 at the norm of 1 kPa
  const auto& stress = state.isotropic_unloading.stress;
  CHECK(stress.x() == Approx(std::numbers::sqrt2 * stress.y()));
  CHECK(stress.norm() == Approx(1000));
  CHECK(stress.y() < 0);
}

TEST_CASE("increments have the norm that is asked for, whatever is imposed") {
  const auto one = inl2_at(0.6), ten = inl2_at(0.6, {.norm = 10e3});
  REQUIRE(one.circle.probes.size() == ten.circle.probes.size());
  for (std::size_t i = 0; i < one.circle.probes.size(); ++i) {
    const sim::Probe &a = one.circle.probes[i], &b = ten.circle.probes[i];
    CHECK(a.stress.norm() == Approx(1e3));
    CHECK(b.stress.norm() == Approx(1e4));
    CHECK(b.second_order_work == Approx(100 * a.second_order_work).margin(1e-9));
    CHECK(a.normalised == b.normalised);
  }
  const auto strain = inl2_at(0.6, {.kind = sim::ProbeKind::strain, .norm = 1e-5});
  for (const sim::Probe& probe : strain.circle.probes) {
    CHECK(probe.strain.norm() == Approx(1e-5));
    CHECK(probe.second_order_work == Approx(probe.stress.dot(probe.strain)).margin(1e-12));
  }
  // The same directions of stress: the unstable ones are as many seen from either side.
  CHECK(strain.circle.least.normalised == Approx(one.circle.least.normalised).epsilon(1e-6));
  CHECK(strain.isotropic_unloading.stress.norm() == Approx(1e3));
}

TEST_CASE("integrated increments tend to the rate") {
  const auto rate = inl2_at(0.6), small = inl2_at(0.6, {.norm = 10, .finite = true}),
             large = inl2_at(0.6, {.norm = 1000, .finite = true});
  const auto off = [&](const study::ProbedState& s) {
    return std::abs(s.circle.cones.at(0).from - rate.circle.cones.at(0).from);
  };
  CHECK(off(small) < 1e-3);
  CHECK(off(small) < off(large));
  CHECK(small.circle.probes.at(3).stress.norm() == Approx(10));
}

TEST_CASE("elasticity has no cone in either plane, and tells its state") {
  const auto set = lab::find_material("elastic/linear");
  const auto axial = study::probe_state(set, loose<Axisymmetric>(set, 100, 0.3), {});
  const auto plane = study::probe_state(set, loose<Tensor>(set, 100, 0.3),
                                        {.plane = sim::ProbePlane::plane_strain});
  for (const auto& state : {axial, plane}) {
    CHECK(state.circle.cones.empty());
    CHECK(state.circle.least.normalised > 0);
    CHECK(state.p == Approx(100e3));
    CHECK(state.q == Approx(30e3));
    CHECK(state.eta() == Approx(0.3));
    CHECK(state.stress(0) == Approx(120e3));
    CHECK(state.stress(1) == state.stress(2));
  }
  CHECK(sim::degrees(axial.isotropic_unloading.angle) == Approx(215.264).margin(1e-3));
  CHECK(sim::degrees(plane.isotropic_unloading.angle) == Approx(225));
}

TEST_CASE("a state that the law refuses is bad input in the law's words") {
  CHECK_THROWS_WITH(inl2_at(1.5), Catch::Contains("the stress ratio"));
  const auto outside = inl2_at(0.2);
  CHECK(outside.all_warnings().empty());
  const auto set = lab::find_material("inl2/S28-general");
  const auto warned = study::probe_state(set, loose<Axisymmetric>(set, 5, 0.2), {});
  REQUIRE(warned.p_eff_outside);
  CHECK_FALSE(warned.void_ratio_outside);
  CHECK(warned.all_warnings() == std::vector<std::string>{*warned.p_eff_outside});
}

TEST_CASE("a test's own increment is probed where it goes") {
  const auto set = lab::find_material("inl2/S28-general");
  auto what = loose<Axisymmetric>(set, 70, 0.6);
  what.test = study::TestedState{};
  what.test->increment = lab::MeasuredIncrement{.angle = 4.0};
  const auto state = study::probe_state(set, what, {});
  REQUIRE(state.own);
  CHECK(state.own->angle == 4.0);
  CHECK(state.own->normalised < 0);
  REQUIRE(state.own_place);
  CHECK(state.own_place->inside);
  const auto strain = study::probe_state(set, what, {.kind = sim::ProbeKind::strain, .norm = 1e-5});
  CHECK(strain.own);
  CHECK_FALSE(strain.own_place);
  auto tensor = loose<Tensor>(set, 70, 0.6);
  tensor.test = what.test;
  CHECK_FALSE(study::probe_state(set, tensor, {.plane = sim::ProbePlane::plane_strain}).own);
}

TEST_CASE("a circle alone is that of the whole study, in as many directions as are asked for") {
  const auto set = lab::find_material("inl2/S28-general");
  const auto what = loose<Axisymmetric>(set, 70, 0.6);
  const auto coarse = study::probed_circle(set, what, {}),
             fine = study::probed_circle(set, what, {.directions = 360});
  CHECK(fine.probes.size() >= 360);
  CHECK(coarse.cones.at(0).from == inl2_at(0.6).circle.cones.at(0).from);
  CHECK(fine.cones.at(0).from == Approx(coarse.cones.at(0).from).epsilon(1e-8));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/incremental_response.hpp"

#include <catch2/catch.hpp>

#include "sim/materials/mohr_coulomb.hpp"
#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/random_tensors.hpp"
#include "tests/sim/materials/umat_fixture.hpp"
#include "tests/sim/stability/stability_states.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

/// Answers and tangents at a sheared state, in random directions.
template <class Space>
void check_response(const Law<Space>& law, double eta, double e) {
  const auto response = response_at(law, 80, eta, e);
  RandomTensors random;
  int loading = 0;
  for (int i = 0; i < 40; ++i) {
    const Vector<Space> v = random.direction<Space>();
    const auto rate = response->to_stress(v);
    REQUIRE(rate.controllable);
    if (rate.active != 0) ++loading;
    const auto driven = point_rate(law, response->state(), MixedControl<Space>::stresses(v));
    CHECK((rate.strain - driven.strain).norm() < 1e-12 * rate.strain.norm());
    CHECK((response->to_strain(rate.strain).stress - v).norm() < 1e-9);

    const auto compliance = response->tangent_compliance(rate);
    const auto stiffness = response->tangent_stiffness(rate);
    REQUIRE((compliance && stiffness));
    CHECK((*compliance * *stiffness - Matrix<Space>::Identity()).norm() < 1e-8);
    CHECK((*compliance * v - rate.strain).norm() < 1e-9 * rate.strain.norm());
    for (int j = 0; j < Space::kSize; ++j) {
      const Vector<Space> aside = 1e-5 * Vector<Space>::Unit(j);
      const auto more = response->to_stress(v + aside), less = response->to_stress(v - aside);
      if (more.active != rate.active || less.active != rate.active) continue;
      const Vector<Space> slope = (more.strain - less.strain) / 2e-5;
      CHECK((compliance->col(j) - slope).norm() < 1e-6 * compliance->norm());
    }
  }
  const auto form = law.response(response->state());
  if (const auto* stiffness = std::get_if<StiffnessForm<Space>>(&form); stiffness != nullptr)
    CHECK((stiffness->mechanisms == 0 || (loading > 5 && loading < 35)));
}

}  // namespace

TEST_CASE("answers are the point driver's, tangents are their derivatives: triaxial") {
  check_response<Axisymmetric>(Sanisand<Axisymmetric>(s28_general()), 0.5, 1.086);
  check_response<Axisymmetric>(Hypoplastic<Axisymmetric>(hostun_moist_tamped()), 0.5, 1.05);
  check_response<Axisymmetric>(inl2(), 0.5, 1.086);
  check_response<Axisymmetric>(octo(), 0.5, 1.086);
}

TEST_CASE("answers are the point driver's, tangents are their derivatives: six components") {
  check_response<Tensor>(Sanisand<Tensor>(s28_general()), 0.5, 1.086);
  check_response<Tensor>(Hypoplastic<Tensor>(hostun_moist_tamped()), 0.5, 1.05);
  check_response<Tensor>(law<Tensor>(Interpolation::inl2, kInl2), 0.5, 1.086);
}

TEST_CASE("a law that integrates itself is asked for small increments") {
  if (!umat_fixture_is_there()) return;
  const auto material = make_umat(umat_fixture());
  const auto response = response_at(*material.axisymmetric, 100, 0.2, 0.8);
  const Vector<Axisymmetric> v(0.6, 0.8);
  const auto rate = response->to_stress(v);
  REQUIRE(rate.controllable);
  const double bulk = 1e3 * kBulk, shear = 1e3 * kShear;  // inside its yield surface: elastic
  const Vector<Axisymmetric> expected =
      isotropic_stiffness<Axisymmetric>(1 / (9 * bulk), 1 / (4 * shear)) * v;
  CHECK((rate.strain - expected).norm() < 1e-3 * expected.norm());
  CHECK((*response->tangent_compliance(rate) * v - expected).norm() < 1e-2 * expected.norm());
}

TEST_CASE("at the limit surface half of the directions have no answer") {
  MohrCoulombParameters p;
  p.young_modulus_pa = 30e6;
  p.poisson_ratio = 0.25;
  p.reference_pressure_pa = 100e3;
  p.friction_angle = radians(34);
  const MohrCoulomb<Axisymmetric> law(p);
  const auto response = response_at(law, 100, stress_ratio_at_friction_angle(radians(34)), 0.8);
  CHECK_FALSE(response->to_stress({1, 0}).controllable);
  CHECK(response->to_stress({-1, 0}).controllable);
  CHECK(response->to_strain({1, -1 / std::numbers::sqrt2}).controllable);
  const auto flowing = response->to_strain({1, -1 / std::numbers::sqrt2});
  CHECK(flowing.active != 0);
  CHECK_FALSE(response->tangent_compliance(flowing));
  CHECK(std::abs(response->tangent_stiffness(flowing)->determinant()) <
        1e-9 * std::pow(response->tangent_stiffness(flowing)->norm(), 2));
}

TEST_CASE("the memory of the state stays: a direction that reverses is answered before it has") {
  const auto law = inl2();
  PointState<Axisymmetric> sheared = state_at(law, 70, 0.6, 1.086);
  const auto fresh = response_at(law, 70, 0.6, 1.086);
  law.turn(sheared, fresh->to_stress({1, 0}));  // has been loaded
  const IncrementalResponse<Axisymmetric> loaded(law, sheared);
  const Vector<Axisymmetric> unloading(-1, 0);
  CHECK(loaded.to_stress(unloading).strain == fresh->to_stress(unloading).strain);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/drucker_prager.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/frictional_sand.hpp"
#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;
using triax::sim::test::kDegree;
using Control = MixedControl<Axisymmetric>;
using TriaxialDruckerPrager = DruckerPrager<Axisymmetric>;

namespace {

DruckerPragerParameters cone_sand(double dilation_deg = 0, double cohesion_pa = 0) {
  return test::frictional_sand<DruckerPragerParameters>(dilation_deg, cohesion_pa);
}

double slope(double degrees) {
  const double s = std::sin(degrees * kDegree);
  return 6 * s / (3 - s);
}

double deviatoric(const Vector<Axisymmetric>& strain) {
  return 2.0 / 3 * deviator_stress<Axisymmetric>(strain);
}

}  // namespace

TEST_CASE("Drucker-Prager: strength at constant p' is M_f p + k, in compression and extension") {
  const TriaxialDruckerPrager law(cone_sand(5, 10e3));
  const double s = std::sin(34 * kDegree);
  const double expected = slope(34) * 200e3 + 6 * 10e3 * std::cos(34 * kDegree) / (3 - s);
  for (const double side : {1.0, -1.0}) {
    const auto step =
        advance_point(law, law.isotropic(200e3, 0.9), Control::stress_path(0, side * 900e3));
    REQUIRE(step.outcome == StepOutcome::lost_control);
    CHECK(step.limiting_variable == 1);
    CHECK(side * step.state.q() == Approx(expected).epsilon(1e-9));
    CHECK(step.done == Approx(expected / 900e3).epsilon(1e-9));
  }
}

TEST_CASE("Drucker-Prager: drained compression ends at 3 p0 M/(3 - M), and dilates by M_g") {
  const TriaxialDruckerPrager law(cone_sand(10));
  const auto start = law.isotropic(100e3, 0.9);
  const double m = slope(34);
  auto step = advance_point(law, start, Control::drained_compression(0.02));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.state.q() == Approx(3 * 100e3 * m / (3 - m)).epsilon(1e-9));
  step = advance_point(law, step.state, Control::drained_compression(0.02));
  CHECK(step.stress_increment.norm() < 1e-3);
  CHECK(trace<Axisymmetric>(step.strain_increment) / deviatoric(step.strain_increment) ==
        Approx(-slope(10)).epsilon(1e-8));
}

TEST_CASE("Drucker-Prager: undrained without dilation stays at constant p' and keeps M_f p0") {
  const TriaxialDruckerPrager law(cone_sand(0));
  auto state = law.isotropic(200e3, 1.0);
  for (int i = 0; i < 10; ++i) {
    state = advance_point(law, state, Control::strain_path(0.01)).state;
    CHECK(state.p() == Approx(200e3).epsilon(1e-12));
  }
  CHECK(state.q() == Approx(slope(34) * 200e3).epsilon(1e-12));
}

TEST_CASE("Drucker-Prager: undrained with dilation climbs the cone") {
  const TriaxialDruckerPrager law(cone_sand(10));
  const auto step = advance_point(law, law.isotropic(200e3, 1.0), Control::strain_path(0.05));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.state.p() > 250e3);
  CHECK(step.state.q() == Approx(slope(34) * step.state.p()).epsilon(1e-12));
  CHECK(step.state.void_ratio == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("Drucker-Prager: q raised beyond the strength loses control of q there") {
  const TriaxialDruckerPrager law(cone_sand());
  const double m = slope(34);
  const auto step =
      advance_point(law, law.isotropic(100e3, 0.9), Control::stress_path(200e3, 600e3));
  REQUIRE(step.outcome == StepOutcome::lost_control);
  CHECK(step.limiting_variable == 1);
  CHECK(step.state.q() == Approx(3 * 100e3 * m / (3 - m)).epsilon(1e-6));
}

TEST_CASE("Drucker-Prager: unloading p' to the apex stops in words") {
  for (const double cohesion : {0.0, 10e3}) {
    const TriaxialDruckerPrager law(cone_sand(0, cohesion));
    const auto step =
        advance_point(law, law.isotropic(100e3, 0.9), Control::stress_path(-150e3, 0));
    CHECK(step.outcome == StepOutcome::failed);
    CHECK_FALSE(step.message.empty());
    CHECK(step.state.stress.allFinite());
    CHECK(step.strain_increment.allFinite());
    const double apex = -cohesion / std::tan(34 * kDegree);
    CHECK(step.state.p() == Approx(apex).margin(2));
    CHECK(law.objection(law.isotropic(apex, 0.9)));
  }
}

TEST_CASE("Drucker-Prager: the tangent is symmetric where flow is associated, only there") {
  test::RandomTensors random;
  for (int i = 0; i < 20; ++i) {
    const auto stress = random.stress<Tensor>(100e3, 0.7);
    const DruckerPrager<Tensor> associated(cone_sand(34)), other(cone_sand(0));
    const auto t = test::tangent_of(associated.response(associated.start(stress, 0.9)), 1);
    CHECK((t - t.transpose()).norm() < 1e-12 * t.norm());
    const auto u = test::tangent_of(other.response(other.start(stress, 0.9)), 1);
    CHECK((u - u.transpose()).norm() > 1e-2 * u.norm());
  }
}

TEST_CASE("Drucker-Prager: axes do not matter, and both spaces agree on triaxial paths") {
  test::RandomTensors random;
  const DruckerPrager<Tensor> law(cone_sand(8, 5e3));
  const TriaxialDruckerPrager triaxial(cone_sand(8, 5e3));
  for (int i = 0; i < 10; ++i) {
    const Matrix<Tensor> turned = rotation(random.turn());
    const auto stress = random.stress<Tensor>(100e3, 0.4);
    const Vector<Tensor> strain = 0.02 * random.direction<Tensor>();
    const auto here =
        advance_point(law, law.start(stress, 0.9), MixedControl<Tensor>::strains(strain));
    const auto there = advance_point(law, law.start(turned * stress, 0.9),
                                     MixedControl<Tensor>::strains(turned * strain));
    CHECK((turned * here.state.stress - there.state.stress).norm() < 1e-3);  // Pa
  }
  for (const double R : {1.0, 0.6, -2.0}) {
    const auto a =
        advance_point(triaxial, triaxial.isotropic(100e3, 0.9), Control::strain_path(0.01, R));
    const auto t =
        advance_point(law, law.isotropic(100e3, 0.9), MixedControl<Tensor>::strain_path(0.01, R));
    CHECK(as_tensor(a.state.stress).isApprox(t.state.stress, 1e-9));
  }
}

TEST_CASE("Drucker-Prager: a stress outside the cone is not moved silently") {
  const TriaxialDruckerPrager law(cone_sand());
  const auto outside = law.start({300e3, std::sqrt(2.0) * 50e3}, 0.9);
  REQUIRE(law.warning(outside));
  CHECK_THAT(*law.warning(outside), Catch::Contains("outside the yield surface"));
  auto settled = outside;
  law.settle(settled, 1);
  CHECK(settled.stress == outside.stress);
  CHECK_FALSE(law.warning(law.isotropic(100e3, 0.9)));
}

TEST_CASE("Drucker-Prager: tension within the cone is said") {
  auto p = cone_sand();
  p.friction_angle = 42 * kDegree;
  const DruckerPrager<Tensor> law(p);
  const auto step =
      advance_point(law, law.isotropic(100e3, 0.9), MixedControl<Tensor>::stress_path(0, -165e3));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.state.stress(0) == Approx(-10e3));
  REQUIRE(law.warning(step.state));
  CHECK_THAT(*law.warning(step.state), Catch::Contains("tensile"));
  CHECK(TriaxialDruckerPrager(p).warning(
      TriaxialDruckerPrager(p).start({-10e3, std::sqrt(2.0) * 155e3}, 0.9)));
}

TEST_CASE("Drucker-Prager: parameters without meaning are refused by name") {
  auto p = cone_sand();
  p.friction_angle = 0;
  CHECK_THROWS_WITH(TriaxialDruckerPrager(p), Catch::Contains("cohesion_kPa"));
  p.friction_angle = 1.6;
  CHECK_THROWS_WITH(TriaxialDruckerPrager(p), Catch::Contains("friction_angle_deg"));
}

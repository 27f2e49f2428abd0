// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/mohr_coulomb.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "sim/law/on_yield.hpp"
#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/frictional_sand.hpp"
#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;
using triax::sim::test::kDegree;
using Control = MixedControl<Axisymmetric>;
using TensorControl = MixedControl<Tensor>;
using TriaxialMohrCoulomb = MohrCoulomb<Axisymmetric>;
using TensorMohrCoulomb = MohrCoulomb<Tensor>;

namespace {

MohrCoulombParameters pyramid_sand(double dilation_deg = 0, double cohesion_pa = 0) {
  return test::frictional_sand<MohrCoulombParameters>(dilation_deg, cohesion_pa);
}

double sine(double degrees) { return std::sin(degrees * kDegree); }
double compression_slope(double degrees) { return 6 * sine(degrees) / (3 - sine(degrees)); }
double extension_slope(double degrees) { return 6 * sine(degrees) / (3 + sine(degrees)); }
double flow_number() { return (1 + sine(34)) / (1 - sine(34)); }

Eigen::Vector3d principal(const Vector<Tensor>& a) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix_of(a)).eigenvalues().reverse();
}

/// ε₁ given, σ₂ and σ₃ held or moved, no shear.
TensorControl true_triaxial(double axial_strain, double d_sigma2, double d_sigma3) {
  TensorControl c;
  c.strain(0, 0) = 1;
  c.stress(1, 1) = c.stress(2, 2) = 1;
  for (int i = 3; i < 6; ++i) c.strain(i, i) = 1;
  c.increment << axial_strain, d_sigma2, d_sigma3, 0, 0, 0;
  return c;
}

}  // namespace

TEST_CASE("Mohr-Coulomb: strength at constant p', compression and extension, both spaces") {
  const double c = 10e3, cosine = std::cos(34 * kDegree);
  const TriaxialMohrCoulomb law(pyramid_sand(5, c));
  const TensorMohrCoulomb full(pyramid_sand(5, c));
  for (const double side : {1.0, -1.0}) {
    const double expected = side > 0
                                ? compression_slope(34) * 200e3 + 6 * c * cosine / (3 - sine(34))
                                : extension_slope(34) * 200e3 + 6 * c * cosine / (3 + sine(34));
    const auto a =
        advance_point(law, law.isotropic(200e3, 0.9), Control::stress_path(0, side * 900e3));
    const auto t = advance_point(full, full.isotropic(200e3, 0.9),
                                 TensorControl::stress_path(0, side * 900e3));
    REQUIRE(a.outcome == StepOutcome::lost_control);
    REQUIRE(t.outcome == StepOutcome::lost_control);
    CHECK(a.limiting_variable == 1);
    CHECK(t.limiting_variable == 1);
    CHECK(side * a.state.q() == Approx(expected).epsilon(1e-9));
    CHECK(t.state.q() == Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("Mohr-Coulomb: sigma1/sigma3 at failure is (1 + sin)/(1 - sin) whatever sigma2") {
  const TensorMohrCoulomb law(pyramid_sand(6));
  for (const double b : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    auto state = law.isotropic(100e3, 0.9);
    const double top = flow_number() * 100e3;
    const auto spread = TensorControl::stresses(
        (Vector<Tensor>() << 0.999 * b * (top - 100e3), b * (top - 100e3) * 0.999, 0, 0, 0, 0)
            .finished());
    state = advance_point(law, state, spread).state;
    const auto step = advance_point(law, state, true_triaxial(0.05, 0, 0));
    INFO("b " << b << ": " << step.message);
    REQUIRE(step.outcome == StepOutcome::accepted);
    CHECK(step.state.stress(0) == Approx(top).epsilon(1e-9));
    CHECK(step.state.stress(2) == Approx(100e3).epsilon(1e-9));
    CHECK(step.stress_increment(1) == Approx(0).margin(1e-3));
  }
}

TEST_CASE("Mohr-Coulomb: plane strain yields on one plane, and dilates by sin psi") {
  const TensorMohrCoulomb law(pyramid_sand(10));
  TensorControl c = true_triaxial(0.02, 0, 0);
  c.stress(1, 1) = 0;
  c.strain(1, 1) = 1;
  auto step = advance_point(law, law.isotropic(100e3, 0.9), c);
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.state.stress(0) == Approx(flow_number() * 100e3).epsilon(1e-9));
  CHECK(step.state.stress(1) > 110e3);
  step = advance_point(law, step.state, c);
  // σ₂ no longer changes: ε₁ + ε₃ = −sin ψ (ε₁ − ε₃).
  const auto& e = step.strain_increment;
  CHECK(step.stress_increment.norm() < 1e-3);
  CHECK((e(0) + e(2)) / (e(0) - e(2)) == Approx(-sine(10)).epsilon(1e-8));
}

TEST_CASE("Mohr-Coulomb: triaxial corners flow with M_g, in compression and extension") {
  const TriaxialMohrCoulomb law(pyramid_sand(10));
  const TensorMohrCoulomb full(pyramid_sand(10));
  for (const double side : {1.0, -1.0}) {
    auto a =
        advance_point(law, law.isotropic(100e3, 0.9), Control::drained_compression(side * 0.02));
    auto t = advance_point(full, full.isotropic(100e3, 0.9),
                           TensorControl::drained_compression(side * 0.02));
    REQUIRE(a.outcome == StepOutcome::accepted);
    REQUIRE(t.outcome == StepOutcome::accepted);
    CHECK(as_tensor(a.state.stress).isApprox(t.state.stress, 1e-9));
    const double m = side > 0 ? compression_slope(34) : extension_slope(34);
    CHECK(a.state.q() == Approx(side * 3 * 100e3 * m / (3 - side * m)).epsilon(1e-9));
    a = advance_point(law, a.state, Control::drained_compression(side * 0.02));
    t = advance_point(full, t.state, TensorControl::drained_compression(side * 0.02));
    CHECK(as_tensor(a.strain_increment).isApprox(t.strain_increment, 1e-8));
    const double dilation = side > 0 ? compression_slope(10) : extension_slope(10);
    CHECK(trace<Axisymmetric>(a.strain_increment) ==
          Approx(-side * dilation * 2 / 3 * deviator_stress<Axisymmetric>(a.strain_increment))
              .epsilon(1e-8));
  }
}

TEST_CASE("Mohr-Coulomb: undrained without dilation stays at constant p' and keeps its q") {
  const TriaxialMohrCoulomb law(pyramid_sand(0));
  const TensorMohrCoulomb full(pyramid_sand(0));
  auto state = law.isotropic(200e3, 1.0);
  auto wide = full.isotropic(200e3, 1.0);
  for (int i = 0; i < 10; ++i) {
    state = advance_point(law, state, Control::strain_path(0.01)).state;
    wide = advance_point(full, wide, TensorControl::strain_path(0.01)).state;
    CHECK(state.p() == Approx(200e3).epsilon(1e-12));
    CHECK(wide.p() == Approx(200e3).epsilon(1e-12));
  }
  CHECK(state.q() == Approx(compression_slope(34) * 200e3).epsilon(1e-12));
  CHECK(wide.q() == Approx(compression_slope(34) * 200e3).epsilon(1e-12));
}

TEST_CASE("Mohr-Coulomb: q raised beyond the strength loses control of q there") {
  const TriaxialMohrCoulomb law(pyramid_sand(4));
  const TensorMohrCoulomb full(pyramid_sand(4));
  const double m = compression_slope(34), expected = 3 * 100e3 * m / (3 - m);
  const auto a = advance_point(law, law.isotropic(100e3, 0.9), Control::stress_path(200e3, 600e3));
  REQUIRE(a.outcome == StepOutcome::lost_control);
  CHECK(a.limiting_variable == 1);
  CHECK(a.state.q() == Approx(expected).epsilon(1e-6));
  const auto t =
      advance_point(full, full.isotropic(100e3, 0.9), TensorControl::stress_path(200e3, 600e3));
  REQUIRE(t.outcome == StepOutcome::lost_control);
  CHECK(t.limiting_variable == 1);
  CHECK(t.state.q() == Approx(expected).epsilon(1e-6));
}

TEST_CASE(
    "Mohr-Coulomb: any strain path keeps every pair of stresses admissible, from corners on") {
  // TriaxialMohrCoulomb failure first, so that two principal stresses are equal; then strains in
  // any direction.
  test::RandomTensors random;
  const TensorMohrCoulomb law(pyramid_sand(10));
  for (const double side : {1.0, -1.0})
    for (int i = 0; i < 12; ++i) {
      const auto corner = advance_point(law, law.isotropic(100e3, 0.9),
                                        TensorControl::drained_compression(side * 0.02))
                              .state;
      const Vector<Tensor> strain = 0.01 * deviator<Tensor>(random.direction<Tensor>());
      const auto step = advance_point(law, corner, TensorControl::strains(strain));
      INFO("side " << side << " case " << i << ": " << step.message << ", error " << step.error);
      // Where the path comes back to an edge while its axes turn, the last step is the shortest.
      REQUIRE(step.done == 1);
      CHECK(step.error < 1e-6);
      const auto s = principal(step.state.stress);
      CHECK(s(0) / s(2) <= flow_number() * (1 + 1e-8));
      auto cut = corner;
      for (int k = 0; k < 50; ++k)
        cut = advance_point(law, cut, TensorControl::strains(strain / 50)).state;
      CHECK((cut.stress - step.state.stress).norm() < 2e-6 * step.state.p());
    }
}

TEST_CASE("Mohr-Coulomb: axes do not matter, on planes nor at corners") {
  test::RandomTensors random;
  const TensorMohrCoulomb law(pyramid_sand(8, 5e3));
  for (int i = 0; i < 12; ++i) {
    const Matrix<Tensor> turned = rotation(random.turn());
    const auto stress = random.stress<Tensor>(100e3, 0.3);
    const Vector<Tensor> strain = 0.02 * random.direction<Tensor>();
    const auto here = advance_point(law, law.start(stress, 0.9), TensorControl::strains(strain));
    const auto there = advance_point(law, law.start(turned * stress, 0.9),
                                     TensorControl::strains(turned * strain));
    REQUIRE(here.outcome == there.outcome);
    // Round-off may isolate an edge a little earlier in one frame: 1e-7 of the stress.
    CHECK((turned * here.state.stress - there.state.stress).norm() < 1e-2);  // Pa

    const auto control = TensorControl::drained_compression(i % 2 == 0 ? 0.02 : -0.02);
    const auto straight = advance_point(law, law.isotropic(100e3, 0.9), control);
    const auto slanted =
        advance_point(law, law.isotropic(100e3, 0.9), test::turned_control(control, turned));
    REQUIRE(straight.outcome == StepOutcome::accepted);
    REQUIRE(slanted.outcome == StepOutcome::accepted);
    CHECK((turned * straight.state.stress).isApprox(slanted.state.stress, 1e-8));
  }
}

TEST_CASE("Mohr-Coulomb: the tangent is symmetric where flow is associated, only there") {
  test::RandomTensors random;
  const TensorMohrCoulomb associated(pyramid_sand(34)), other(pyramid_sand(0));
  for (const unsigned set : {1U, 2U, 3U, 5U}) {
    const auto stress = random.stress<Tensor>(100e3, 0.5);
    const auto t = test::tangent_of(associated.response(associated.start(stress, 0.9)), set);
    CHECK((t - t.transpose()).norm() < 1e-10 * t.norm());
    const auto u = test::tangent_of(other.response(other.start(stress, 0.9)), set);
    CHECK((u - u.transpose()).norm() > 1e-2 * u.norm());
  }
}

TEST_CASE("Mohr-Coulomb: unloading leaves the surface elastic") {
  const TensorMohrCoulomb law(pyramid_sand(5));
  const auto failed =
      advance_point(law, law.isotropic(100e3, 0.9), TensorControl::drained_compression(0.03)).state;
  const auto back = advance_point(law, failed, TensorControl::drained_compression(-0.001));
  CHECK(back.state.stress(0) - failed.stress(0) == Approx(-30e6 * 0.001).epsilon(1e-9));
  // On into extension: the other corner is met.
  const auto beyond = advance_point(law, failed, TensorControl::drained_compression(-0.03));
  REQUIRE(beyond.outcome == StepOutcome::accepted);
  CHECK(beyond.state.stress(0) == Approx(100e3 / flow_number()).epsilon(1e-9));
}

TEST_CASE("Mohr-Coulomb: unloading p' to the apex stops in words") {
  for (const double cohesion : {0.0, 10e3}) {
    const TriaxialMohrCoulomb law(pyramid_sand(0, cohesion));
    const TensorMohrCoulomb full(pyramid_sand(0, cohesion));
    const double apex = -cohesion / std::tan(34 * kDegree);
    const auto a = advance_point(law, law.isotropic(100e3, 0.9), Control::stress_path(-150e3, 0));
    const auto t =
        advance_point(full, full.isotropic(100e3, 0.9), TensorControl::stress_path(-150e3, 0));
    CHECK(a.outcome == StepOutcome::failed);
    CHECK(t.outcome == StepOutcome::failed);
    CHECK_FALSE(a.message.empty());
    CHECK_FALSE(t.message.empty());
    CHECK(a.state.p() == Approx(apex).margin(2));
    CHECK(t.state.p() == Approx(apex).margin(2));
    CHECK(t.strain_increment.allFinite());
    CHECK(law.objection(law.isotropic(apex, 0.9)));
  }
}

TEST_CASE("Mohr-Coulomb: a stress outside the surface is not moved silently") {
  const TensorMohrCoulomb law(pyramid_sand());
  Vector<Tensor> stress;
  stress << 500e3, 120e3, 50e3, 0, 0, 0;
  const auto outside = law.start(stress, 0.9);
  REQUIRE(law.warning(outside));
  CHECK_THAT(*law.warning(outside), Catch::Contains("outside the yield surface"));
  auto settled = outside;
  law.settle(settled, 1);
  CHECK(settled.stress == outside.stress);
}

TEST_CASE("Mohr-Coulomb: a settled state stays as it is to the bit, on planes and at corners") {
  test::RandomTensors random;
  const TensorMohrCoulomb law(pyramid_sand(5, 10e3));
  const auto start = law.isotropic(100e3, 0.9);
  for (int i = 0; i < 12; ++i) {
    const auto control = i % 3 == 2 ? true_triaxial(0.03, 20e3, 0)
                                    : TensorControl::drained_compression(i % 3 == 0 ? 0.03 : -0.03);
    const auto step =
        advance_point(law, start, test::turned_control(control, rotation(random.turn())));
    REQUIRE(step.outcome == StepOutcome::accepted);
    const unsigned standing = mechanisms_on_yield(law, step.state, 3);
    REQUIRE(standing != 0);
    auto again = step.state;
    law.settle(again, standing);
    CHECK(again.stress == step.state.stress);
    CHECK(again.memory == step.state.memory);
    again.stress *= 1 + 1e-10;
    const Vector<Tensor> beside = again.stress;
    law.settle(again, standing);
    CHECK(again.stress != beside);
  }
}

TEST_CASE("Mohr-Coulomb: the distance is that of this law and stress, whatever was asked before") {
  std::optional<TensorMohrCoulomb> law;
  const auto distance = [&law](double cohesion_pa, double axial_pa) {
    law.emplace(pyramid_sand(0, cohesion_pa));  // where the last one was
    return law->yield_distance(
        law->start(as_tensor(components(AxisymmetricStress{axial_pa, 100e3})), 0.9), 0);
  };
  const double first = distance(0, 200e3);
  CHECK(distance(20e3, 200e3) < first - 0.05);
  CHECK(distance(20e3, 300e3) > distance(20e3, 200e3) + 0.05);
  CHECK(distance(0, 200e3) == first);
}

TEST_CASE("Mohr-Coulomb: without friction it is Tresca's law") {
  auto p = pyramid_sand(0, 50e3);
  p.friction_angle = 0;
  const TensorMohrCoulomb law(p);
  const auto step = advance_point(law, law.isotropic(100e3, 0.9), TensorControl::strain_path(0.02));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.state.q() == Approx(100e3).epsilon(1e-9));
  CHECK_FALSE(law.limit_stress_ratio());
  p.cohesion_pa = 0;
  CHECK_THROWS_WITH(TensorMohrCoulomb(p), Catch::Contains("friction_angle_deg"));
}

TEST_CASE(
    "Mohr-Coulomb: points driven in turn, by laws in the same place, do not disturb another") {
  const auto control = true_triaxial(1e-3, 500, -500);
  const auto next = [&control](const TensorMohrCoulomb& law, const PointState<Tensor>& s) {
    const auto step = advance_point(law, s, control);
    REQUIRE(step.outcome == StepOutcome::accepted);
    return step.state;
  };
  const auto alone = [&next](double cohesion_pa) {
    const TensorMohrCoulomb law(pyramid_sand(5, cohesion_pa));
    PointState<Tensor> s = law.isotropic(100e3, 0.8);
    for (int i = 0; i < 20; ++i) s = next(law, s);
    return s;
  };
  const double cohesion[] = {0, 20e3};
  PointState<Tensor> s[] = {TensorMohrCoulomb(pyramid_sand(5, 0)).isotropic(100e3, 0.8),
                            TensorMohrCoulomb(pyramid_sand(5, 20e3)).isotropic(100e3, 0.8)};
  std::optional<TensorMohrCoulomb> law;
  for (int i = 0; i < 40; ++i) {
    law.emplace(pyramid_sand(5, cohesion[i % 2]));
    s[i % 2] = next(*law, s[i % 2]);
    // Asked of another's state in between, at which only the strength differs.
    law.emplace(pyramid_sand(5, cohesion[1 - i % 2]));
    static_cast<void>(law->yield_distance(s[i % 2], 1));
  }
  for (int i = 0; i < 2; ++i) {
    const auto expected = alone(cohesion[i]);
    CHECK(s[i].stress == expected.stress);
    CHECK(s[i].memory == expected.memory);
  }
}

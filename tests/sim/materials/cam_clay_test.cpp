// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/cam_clay.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;
using Control = MixedControl<Axisymmetric>;
using TriaxialCamClay = CamClay<Axisymmetric>;

namespace {

CamClayParameters check_set(double ocr = 1) { return {0.1, 0.01, 1, 0.3, ocr}; }
CamClayParameters hostun_like() { return {0.032, 0.006, 1.2872, 0.2, 1}; }

}  // namespace

TEST_CASE("Cam-Clay: the undrained path of a normally consolidated state is its closed form") {
  for (const auto& parameters : {check_set(), hostun_like()}) {
    const TriaxialCamClay law(parameters);
    const double m2 = parameters.critical_stress_ratio * parameters.critical_stress_ratio;
    const double exponent = 1 - parameters.swelling_slope / parameters.compression_slope;
    auto state = law.isotropic(200e3, 0.8);
    for (int i = 0; i < 60; ++i) {
      const auto step = advance_point(law, state, Control::strain_path(0.0005 * (1 + i / 5)));
      REQUIRE(step.outcome == StepOutcome::accepted);
      state = step.state;
      const double eta = state.q() / state.p();
      CHECK(state.p() == Approx(200e3 * std::pow(m2 / (m2 + eta * eta), exponent)).epsilon(1e-8));
    }
  }
}

TEST_CASE("Cam-Clay: the check set ends undrained at p' = q = 107.18 kPa") {
  const TriaxialCamClay law(check_set());
  const auto step = advance_point(law, law.isotropic(200e3, 0.8), Control::strain_path(0.5));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.state.p() / 1e3 == Approx(107.18).margin(0.005));
  CHECK(step.state.q() / 1e3 == Approx(107.18).margin(0.005));
  CHECK(step.state.p() == Approx(200e3 * std::pow(2, -0.9)).epsilon(1e-7));
}

TEST_CASE("Cam-Clay: negative control: q rises and work stays positive all the way up to M") {
  const TriaxialCamClay law(hostun_like());
  auto state = law.isotropic(100e3, 1.086);
  int stations = 0;
  while (state.q() / state.p() < 0.999 * 1.2872) {
    const auto rate = point_rate(law, state, Control::strain_path(1));
    REQUIRE(deviator_stress<Axisymmetric>(rate.stress) > 0);
    REQUIRE(rate.second_order_work() > 0);
    CHECK(point_rate(law, state, Control::stress_path(-1, 0)).second_order_work() > 0);
    state = advance_point(law, state, Control::strain_path(2e-4)).state;
    ++stations;
  }
  CHECK(stations > 50);
}

TEST_CASE("Cam-Clay: isotropic compression and swelling follow their lines in e, ln p'") {
  const TriaxialCamClay law(check_set());
  const auto up = advance_point(law, law.isotropic(100e3, 1.2), Control::stress_path(300e3, 0));
  REQUIRE(up.outcome == StepOutcome::accepted);
  CHECK(up.state.void_ratio == Approx(1.2 - 0.1 * std::log(4)).epsilon(1e-9));
  CHECK(law.preconsolidation(up.state) == Approx(400e3));
  const auto down = advance_point(law, up.state, Control::stress_path(-350e3, 0));
  CHECK(down.state.void_ratio == Approx(up.state.void_ratio + 0.01 * std::log(8)).epsilon(1e-9));
  CHECK(law.preconsolidation(down.state) == Approx(400e3));
}

TEST_CASE("Cam-Clay: drained compression ends on the critical state line") {
  const TriaxialCamClay law(check_set());
  const auto step =
      advance_point(law, law.isotropic(200e3, 1.2), Control::drained_compression(1.5));
  REQUIRE(step.outcome == StepOutcome::accepted);
  const double p = 3 * 200e3 / (3 - 1);
  CHECK(step.state.p() == Approx(p).epsilon(1e-4));
  CHECK(step.state.q() == Approx(p).epsilon(1e-4));
  CHECK(step.state.void_ratio ==
        Approx(1.2 - 0.1 * std::log(2 * p / 200e3) + 0.01 * std::log(2)).epsilon(1e-4));
}

TEST_CASE("Cam-Clay: an overconsolidated state is elastic up to its surface, then softens") {
  const TriaxialCamClay law(check_set(8));
  auto state = law.isotropic(50e3, 0.8);
  CHECK(law.yield_distance(state, 0) == Approx(1.0 / 8 - 1));
  // Drained at constant p': yield at q = M √(p (p_c − p)).
  const auto loaded = advance_point(law, state, Control::stress_path(0, 500e3));
  REQUIRE(loaded.outcome == StepOutcome::lost_control);
  CHECK(loaded.limiting_variable == 1);
  CHECK(loaded.state.q() == Approx(std::sqrt(50e3 * 350e3)).epsilon(1e-6));
  CHECK(law.preconsolidation(loaded.state) == Approx(400e3));
  // Strain control goes on: dilation, and q falls to M p.
  Control held;
  held.stress << 1.0 / 3, std::sqrt(2.0) / 3, 0, 0;
  held.strain << 0, 0, 1, -1 / std::sqrt(2.0);
  held.increment << 0, 1.0;
  const auto softened = advance_point(law, loaded.state, held);
  REQUIRE(softened.outcome == StepOutcome::accepted);
  CHECK(softened.state.q() == Approx(50e3).epsilon(1e-4));
  CHECK(softened.state.void_ratio > loaded.state.void_ratio);
}

TEST_CASE("Cam-Clay: q raised beyond the critical state loses control of q there") {
  const TriaxialCamClay law(check_set());
  const auto step =
      advance_point(law, law.isotropic(200e3, 1.2), Control::stress_path(200e3, 600e3));
  REQUIRE(step.outcome == StepOutcome::lost_control);
  CHECK(step.limiting_variable == 1);
  // The critical state is approached and never reached: control ends at a strain of 100 %.
  CHECK(step.state.q() == Approx(300e3).epsilon(1e-5));
  CHECK(step.state.q() / step.state.p() == Approx(1).epsilon(1e-5));
}

TEST_CASE("Cam-Clay: the ratio of plastic strains is that of the flow rule, in both senses") {
  const TriaxialCamClay law(check_set());
  for (const double eta : {0.3, 0.8, -0.5}) {
    auto state =
        law.start({200e3 * (1 + 2 * eta / 3), std::sqrt(2.0) * 200e3 * (1 - eta / 3)}, 0.9);
    const auto form = std::get<StiffnessForm<Axisymmetric>>(law.response(state));
    const Vector<Axisymmetric> flow = form.stiffness.inverse() * form.relaxation[0];
    CHECK(trace<Axisymmetric>(flow) / (2.0 / 3 * deviator_stress<Axisymmetric>(flow)) ==
          Approx((1 - eta * eta) / (2 * eta)).epsilon(1e-10));
  }
}

TEST_CASE("Cam-Clay: symmetric, independent of axes, the same in both spaces") {
  test::RandomTensors random;
  const CamClay<Tensor> law(check_set(1.3));
  const TriaxialCamClay triaxial(check_set(1.3));
  for (int i = 0; i < 10; ++i) {
    const auto stress = random.stress<Tensor>(150e3, 0.5);
    const auto t = test::tangent_of(law.response(law.start(stress, 0.9)), 1);
    CHECK((t - t.transpose()).norm() < 1e-12 * t.norm());
    const Matrix<Tensor> turned = rotation(random.turn());
    const Vector<Tensor> strain = 0.01 * random.direction<Tensor>();
    const auto here =
        advance_point(law, law.start(stress, 0.9), MixedControl<Tensor>::strains(strain));
    const auto there = advance_point(law, law.start(turned * stress, 0.9),
                                     MixedControl<Tensor>::strains(turned * strain));
    CHECK((turned * here.state.stress).isApprox(there.state.stress, 1e-8));
  }
  for (const double R : {1.0, 0.6, -2.0}) {
    const auto a =
        advance_point(triaxial, triaxial.isotropic(100e3, 0.9), Control::strain_path(0.02, R));
    const auto t =
        advance_point(law, law.isotropic(100e3, 0.9), MixedControl<Tensor>::strain_path(0.02, R));
    CHECK(as_tensor(a.state.stress).isApprox(t.state.stress, 1e-8));
    CHECK(triaxial.preconsolidation(a.state) == Approx(law.preconsolidation(t.state)));
  }
}

TEST_CASE("Cam-Clay: unloading into tension stops in words") {
  const TriaxialCamClay law(check_set());
  const auto step = advance_point(law, law.isotropic(200e3, 0.8), Control::stress_path(-300e3, 0));
  CHECK(step.outcome == StepOutcome::failed);
  CHECK_THAT(step.message, Catch::Contains("p' is not above 0"));
  CHECK(step.state.p() > 0);
  CHECK(std::isfinite(step.state.void_ratio));
}

TEST_CASE("Cam-Clay: parameters without meaning are refused by name") {
  CHECK_THROWS_WITH(TriaxialCamClay({0.01, 0.02, 1, 0.3, 1}), Catch::Contains("swelling_slope"));
  CHECK_THROWS_WITH(TriaxialCamClay({0.1, 0.01, 1, 0.3, 0.5}),
                    Catch::Contains("overconsolidation_ratio is 0.5"));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/point_driver.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/materials/sanisand.hpp"
#include "tests/sim/materials/parameter_sets.hpp"

using namespace triax::sim;
using Control = MixedControl<Axisymmetric>;
using Triaxial = Sanisand<Axisymmetric>;

TEST_CASE("the result does not depend on how the path is cut") {
  const Triaxial law(test::s28_general());
  const auto start = law.isotropic(300e3, 1.06);
  const auto at_once = advance_point(law, start, Control::strain_path(0.02));
  REQUIRE(at_once.outcome == StepOutcome::accepted);
  auto cut = start;
  for (int i = 0; i < 997; ++i)
    cut = advance_point(law, cut, Control::strain_path(0.02 / 997)).state;
  CHECK(at_once.state.p() == Approx(cut.p()).epsilon(1e-8));
  CHECK(at_once.state.q() == Approx(cut.q()).epsilon(1e-8));
}

TEST_CASE("mixed conditions are met to round-off of the integration") {
  const Triaxial law(test::s28_general());
  const auto start = law.isotropic(200e3, 1.0);
  const auto step = advance_point(law, start, Control::drained_compression(0.01));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.strain_increment(0) == Approx(0.01).epsilon(1e-12));
  CHECK(step.stress_increment(1) == Approx(0).margin(1e-4));
  CHECK(step.state.q() == Approx(step.stress_increment(0)));
  CHECK(step.state.q() > 50e3);

  const auto path = advance_point(law, start, Control::strain_path(0.005, 0.7));
  CHECK(path.strain_increment(0) + 1.4 / std::sqrt(2.0) * path.strain_increment(1) ==
        Approx(0).margin(1e-14));
}

TEST_CASE("control of q is lost at the undrained peak and the limiting_variable is named") {
  const Triaxial law(test::s28_general());
  const auto start = law.isotropic(100e3, 1.086);
  Control load;  // q raised at constant volume
  load.stress << 1, -1 / std::sqrt(2.0), 0, 0;
  load.strain << 0, 0, 1, std::sqrt(2.0);
  load.increment << 60e3, 0;
  const auto step = advance_point(law, start, load);
  CHECK(step.outcome == StepOutcome::lost_control);
  CHECK(step.limiting_variable == 0);
  CHECK(step.state.q() / 1e3 == Approx(37.21).margin(0.006));
  CHECK(step.done == Approx(37.21 / 60).margin(2e-4));
  CHECK(step.state.q() / step.state.p() == Approx(0.5878).margin(5e-4));
  CHECK(start.p() == Approx(100e3));
}

TEST_CASE("conditions that say the same twice are refused") {
  const Triaxial law(test::s28_general());
  Control twice;
  twice.strain << 1, 2, 2, 4;
  twice.increment << 1e-3, 2e-3;
  const auto step = advance_point(law, law.isotropic(100e3, 1.0), twice);
  CHECK(step.outcome == StepOutcome::failed);
  CHECK_FALSE(step.message.empty());
  CHECK(step.done == 0);
}

TEST_CASE("second-order work of a step is that of its rate, and vanishes at the undrained peak") {
  const Triaxial law(test::s28_general());
  const auto state =
      advance_point(law, law.isotropic(100e3, 1.086), Control::strain_path(0.003)).state;
  const auto rate = point_rate(law, state, Control::strain_path(1));
  const auto step = advance_point(law, state, Control::strain_path(1e-7));
  CHECK(step.second_order_work() == Approx(rate.second_order_work() * 1e-14).epsilon(1e-3));
  CHECK(rate.second_order_work() > 0);
  const auto beyond = advance_point(law, state, Control::strain_path(0.003)).state;
  CHECK(point_rate(law, beyond, Control::strain_path(1)).second_order_work() < 0);
}

TEST_CASE("a liquefying specimen is followed to large strain without a stress of zero") {
  const Triaxial law(test::s28_general());
  const auto step = advance_point(law, law.isotropic(100e3, 1.19), Control::strain_path(0.3));
  CHECK(step.outcome == StepOutcome::accepted);
  CHECK(step.state.p() > 0);
  CHECK(step.state.p() < 2e3);
  CHECK(std::isfinite(step.state.q()));
}

TEST_CASE("a stress path into tension stops with words, not with NaN") {
  const Triaxial law(test::s28_general());
  const auto step = advance_point(law, law.isotropic(100e3, 1.0), Control::stress_path(-150e3, 0));
  CHECK(step.outcome != StepOutcome::accepted);
  CHECK(step.state.p() > 0);
  CHECK(step.done < 1);
  CHECK(step.strain_increment.allFinite());
  CHECK_FALSE(step.message.empty());
}

TEST_CASE("a closed stress cycle of large amplitude compacts loose sand") {
  const Triaxial law(test::s28_general());
  auto state = law.isotropic(200e3, 0.9);
  for (int i = 0; i < 4; ++i)
    for (const double dq : {60e3, -120e3, 60e3}) {
      const auto step = advance_point(law, state, Control::stress_path(0, dq));
      REQUIRE(step.outcome == StepOutcome::accepted);
      state = step.state;
    }
  CHECK(state.q() == Approx(0).margin(1));
  CHECK(state.void_ratio < 0.9);
}

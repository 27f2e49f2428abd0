// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/self_driven.hpp"

#include <catch2/catch.hpp>

#include "sim/materials/elastic.hpp"

using namespace triax::sim;
using State = PointState<Axisymmetric>;
using Control = MixedControl<Axisymmetric>;

namespace {

struct Counter : Interior {
  int increments = 0;
};

/// Strain follows the first condition alone; nothing is ever integrated.
struct Stubborn final : Law<Axisymmetric>, SelfDriven<Axisymmetric> {
  void response(const State&, Response<Axisymmetric>&) const override { FAIL("nobody asks this"); }
  const SelfDriven<Axisymmetric>* self_driven() const override { return this; }
  PointStep<Axisymmetric> drive(const State& state, const Control& control) const override {
    PointStep<Axisymmetric> step;
    auto next = std::make_shared<Counter>();
    next->increments =
        1 + (state.interior ? static_cast<const Counter&>(*state.interior).increments : 0);
    step.state = state;
    step.state.interior = next;
    step.outcome = StepOutcome::accepted;
    step.done = 1;
    step.strain_increment << control.increment(0), 0;
    return step;
  }
  PointRate<Axisymmetric> rate(const State&, const Control& control) const override {
    PointRate<Axisymmetric> rate;
    rate.controllable = true;
    rate.strain << control.increment(0), 0;
    return rate;
  }
  bool sustains(const State&, const Control&) const override { return true; }
  DrivingTolerance tolerance(const State&) const override { return {1, 1e-8}; }
};

}  // namespace

TEST_CASE("a self-driven law is moved by itself, and its interior goes with the state") {
  const Stubborn law;
  const State start = law.isotropic(1e5, 0.8);
  const auto control = Control::strain_path(3e-4);
  const auto first = advance_point<Axisymmetric>(law, start, control);
  const State copy = first.state;
  const auto second = advance_point<Axisymmetric>(law, copy, control);
  CHECK(first.strain_increment(0) == 3e-4);
  CHECK(start.interior == nullptr);
  CHECK(copy.interior == first.state.interior);
  CHECK(static_cast<const Counter&>(*second.state.interior).increments == 2);
  CHECK(static_cast<const Counter&>(*copy.interior).increments == 1);
  CHECK(point_rate<Axisymmetric>(law, start, control).strain(0) == 3e-4);
}

TEST_CASE("a self-driven law is not moved from a state that it objects to") {
  const Stubborn law;
  const auto step =
      advance_point<Axisymmetric>(law, law.isotropic(-1, 0.8), Control::strain_path(1e-4));
  CHECK(step.outcome == StepOutcome::failed);
  CHECK(step.state.interior == nullptr);
}

TEST_CASE("all other laws have no interior and drive nothing") {
  ElasticParameters p;
  p.young_modulus_pa = 30e6;
  p.poisson_ratio = 0.2;
  p.reference_pressure_pa = 1e5;
  const Elastic<Axisymmetric> law(p);
  CHECK(law.self_driven() == nullptr);
  CHECK(law.isotropic(1e5, 0.8).interior == nullptr);
}

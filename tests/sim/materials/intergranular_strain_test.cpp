// SPDX-License-Identifier: GPL-3.0-or-later
// Hypoplasticity with intergranular strain: what is remembered of the last strains.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/materials/hypoplastic_paths.hpp"
#include "tests/sim/materials/hypoplastic_sets.hpp"

using namespace triax::sim;
using triax::sim::test::Dice;
using triax::sim::test::eta;
using triax::sim::test::kHostunTests;
using triax::sim::test::run;
using triax::sim::test::strained;
using triax::sim::test::undrained_peak;
using TriaxialHypoplastic = Hypoplastic<Axisymmetric>;
using TensorHypoplastic = Hypoplastic<Tensor>;
using Control = MixedControl<Axisymmetric>;
using State = PointState<Axisymmetric>;

TEST_CASE("with the intergranular strain full along the path the base law remains") {
  Dice dice;
  const auto set = test::hostun_moist_tamped();
  const TensorHypoplastic base(set), law(test::with_intergranular_strain(set));
  for (int i = 0; i < 50; ++i) {
    auto state = dice.state(law);
    const Vector<Tensor> along = dice.direction<Tensor>();
    state.memory = 1e-4 * along;
    const auto expected = strained<Tensor>(base, state, along).stress;
    CHECK((strained<Tensor>(law, state, along).stress - expected).norm() < 1e-9 * expected.norm());
  }
}

TEST_CASE("after a reversal the stiffness is m_R times the linear part, after a turn m_T times") {
  Dice dice;
  const auto set = test::hostun_moist_tamped();
  const TensorHypoplastic base(set), law(test::with_intergranular_strain(set));
  for (int i = 0; i < 50; ++i) {
    auto state = dice.state(law);
    const Vector<Tensor> along = dice.direction<Tensor>();
    state.memory = 1e-4 * along;
    const auto response = base.response(state);
    const Matrix<Tensor>& linear = std::get<StiffnessForm<Tensor>>(response).stiffness;
    CHECK(strained<Tensor>(law, state, -along).stress.isApprox(-5 * linear * along, 1e-9));
    Vector<Tensor> across = dice.direction<Tensor>();
    across = (across - across.dot(along) * along).eval();
    CHECK(strained<Tensor>(law, state, across).stress.isApprox(2 * linear * across, 1e-9));
    // Nothing remembered: m_R in every direction.
    state.memory.setZero();
    CHECK(strained<Tensor>(law, state, along).stress.isApprox(5 * linear * along, 1e-9));
  }
}

TEST_CASE("intergranular strain follows the strain, never beyond its range") {
  const TriaxialHypoplastic law(test::with_intergranular_strain(test::hostun_moist_tamped()));
  State state = law.isotropic(200e3, 0.95);
  CHECK(law.mobilisation(state) == Approx(1));
  CHECK(state.memory(0) == Approx(1e-4 / std::sqrt(3.0)));
  double smallest = 1;
  for (int cycle = 0; cycle < 3; ++cycle)
    for (const double amplitude : {4e-4, -8e-4, 4e-4})
      for (int i = 0; i < 40; ++i) {
        state = run(law, state, Control::strain_path(amplitude / 40));
        CHECK(law.mobilisation(state) <= 1 + 1e-9);
        smallest = std::min(smallest, law.mobilisation(state));
      }
  CHECK(smallest < 0.3);
  // From nothing, along a straight path, ρ grows to 1 as dρ = (1 − √ρ) dε/R.
  state.memory.setZero();
  const double strain = 3e-4, length = strain * std::sqrt(1.5);
  state = run(law, state, Control::strain_path(strain));
  const double root = std::sqrt(law.mobilisation(state));
  CHECK(-2 * (root + std::log(1 - root)) == Approx(length / 1e-4).epsilon(1e-6));
}

TEST_CASE("the path through a reversal does not depend on how it is cut") {
  const TriaxialHypoplastic law(test::with_intergranular_strain(test::hostun_moist_tamped()));
  const State loaded = run(law, law.isotropic(200e3, 0.95), Control::drained_compression(0.003));
  const State at_once = run(law, loaded, Control::drained_compression(-0.002));
  State cut = loaded;
  for (int i = 0; i < 37; ++i) cut = run(law, cut, Control::drained_compression(-0.002 / 37));
  CHECK(cut.q() == Approx(at_once.q()).epsilon(1e-6));
  CHECK(cut.void_ratio == Approx(at_once.void_ratio).epsilon(1e-8));
}

TEST_CASE("with full intergranular strain the undrained peak moves by less than 2 %") {
  const auto set = test::hostun_moist_tamped();
  const TriaxialHypoplastic base(set), law(test::with_intergranular_strain(set));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [p0, e] = kHostunTests[i];
    const State with = undrained_peak(law, p0, e), without = undrained_peak(base, p0, e);
    CHECK(with.q() == Approx(without.q()).epsilon(0.02));
    CHECK(eta(with) == Approx(eta(without)).epsilon(0.02));
    CHECK(with.q() != without.q());
  }
}

TEST_CASE("small cycles barely change the state once the intergranular strain is there") {
  const auto set = test::hostun_moist_tamped();
  const TriaxialHypoplastic base(set), law(test::with_intergranular_strain(set));
  double fall = 0, fall_without = 0;
  for (const TriaxialHypoplastic* which : {&law, &base}) {
    State state = which->isotropic(200e3, 0.9);
    for (int cycle = 0; cycle < 10; ++cycle)
      for (const double part : {2e-5, -4e-5, 2e-5})
        state = run(*which, state, Control::strain_path(part));
    (which == &law ? fall : fall_without) = 200e3 - state.p();
  }
  CHECK(fall_without > 5e3);
  CHECK(fall < 0.2 * fall_without);
}

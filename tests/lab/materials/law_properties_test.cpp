// SPDX-License-Identifier: GPL-3.0-or-later
// What every shipped set of every law must hold, whatever the law: a new law is covered as soon as
// its parameter file is there.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "tests/lab/materials/each_law.hpp"
#include "tests/sim/materials/random_tensors.hpp"

using namespace triax;
using namespace triax::sim;
using namespace triax::lab::test;

namespace {

constexpr int kRepeats = 4;

/// A stress near kPressure; of a law whose axes are fixed without shear.
template <class Space>
Vector<Space> random_stress(const Law<Space>& law, sim::test::RandomTensors& random) {
  Vector<Space> stress = random.stress<Space>(kPressure, 0.3);
  if constexpr (Space::kSize == 6)
    if (std::holds_alternative<InterpolatedForm<Tensor>>(law.response(isotropic_state(law))))
      stress.template tail<3>().setZero();
  return stress;
}

/// Any rotation, or one that exchanges axes for a law whose axes are fixed.
Eigen::Matrix3d allowed_turn(const Law<Tensor>& law, const PointState<Tensor>& state,
                             sim::test::RandomTensors& random) {
  if (!std::holds_alternative<InterpolatedForm<Tensor>>(law.response(state))) return random.turn();
  Eigen::Matrix3d exchange;
  exchange << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return exchange;
}

}  // namespace

TEST_CASE("every law: the response turns with the axes") {
  sim::test::RandomTensors random;
  Counted turned_states;
  each_law<Tensor>([&](const lab::MaterialSet& set, const Law<Tensor>& law) {
    for (int i = 0; i < kRepeats; ++i) {
      const Vector<Tensor> stress = random_stress(law, random);
      const auto here = admitted(law, stress);
      if (!here) continue;
      ++turned_states[set.law->name];
      const Matrix<Tensor> turned = rotation(allowed_turn(law, *here, random));
      const auto there = law.start(turned * stress, here->void_ratio);
      const Vector<Tensor> strain = 1e-3 * random.direction<Tensor>();
      const auto straight = point_rate(law, *here, MixedControl<Tensor>::strains(strain));
      const auto slanted = point_rate(law, there, MixedControl<Tensor>::strains(turned * strain));
      CHECK((turned * straight.stress - slanted.stress).norm() < 1e-8 * straight.stress.norm());
      const auto a = advance_point(law, *here, MixedControl<Tensor>::strains(strain));
      const auto b = advance_point(law, there, MixedControl<Tensor>::strains(turned * strain));
      INFO(a.message);
      CHECK(a.outcome == b.outcome);
      // Just after a reversal a law may be all but infinitely stiff: the integration's own error.
      CHECK((turned * a.state.stress - b.state.stress).norm() < 1e-4 * kPressure);
    }
  });
  turned_states.require_all<Tensor>();
}

TEMPLATE_TEST_CASE("every law: the rate is homogeneous of degree one", "", Axisymmetric, Tensor) {
  sim::test::RandomTensors random;
  Counted scaled_states;
  each_law<TestType>([&](const lab::MaterialSet& set, const Law<TestType>& law) {
    for (int i = 0; i < kRepeats; ++i) {
      const auto state = admitted(law, random_stress(law, random));
      if (!state) continue;
      ++scaled_states[set.law->name];
      const Vector<TestType> strain = random.direction<TestType>();
      const auto one = point_rate(law, *state, MixedControl<TestType>::strains(strain));
      REQUIRE(one.controllable);
      for (const double scale : {1e-4, 30.0}) {
        const auto scaled =
            point_rate(law, *state, MixedControl<TestType>::strains(scale * strain));
        REQUIRE(scaled.controllable);
        CHECK((scaled.stress - scale * one.stress).norm() < 1e-9 * scale * one.stress.norm());
      }
    }
  });
  scaled_states.require_all<TestType>();
}

TEST_CASE("every law: axisymmetry and the full tensor agree on triaxial paths") {
  using A = MixedControl<Axisymmetric>;
  using T = MixedControl<Tensor>;
  each_law<Tensor>([&](const lab::MaterialSet& set, const Law<Tensor>& law) {
    const auto& triaxial = *set.material.axisymmetric;
    const std::pair<A, T> paths[] = {{A::strain_path(0.003), T::strain_path(0.003)},
                                     {A::strain_path(-0.003), T::strain_path(-0.003)},
                                     {A::strain_path(0.003, 0.5), T::strain_path(0.003, 0.5)},
                                     {A::drained_compression(0.003), T::drained_compression(0.003)},
                                     {A::stress_path(-10e3, 10e3), T::stress_path(-10e3, 10e3)}};
    for (const auto& [narrow, wide] : paths) {
      const auto a = advance_point(triaxial, isotropic_state(triaxial), narrow);
      const auto t = advance_point(law, isotropic_state(law), wide);
      INFO(a.message << " / " << t.message);
      CHECK(a.outcome == t.outcome);
      CHECK((as_tensor(a.state.stress) - t.state.stress).norm() < 1e-6 * kPressure);
      CHECK(a.state.void_ratio == Approx(t.state.void_ratio).margin(1e-9));
    }
  });
}

TEST_CASE("laws that promise a symmetric tangent have one") {
  const std::set<std::string> symmetric = {"elastic", "cam_clay"};
  sim::test::RandomTensors random;
  int checked = 0;
  each_law<Tensor>([&](const lab::MaterialSet& set, const Law<Tensor>& law) {
    if (!symmetric.contains(set.law->name)) return;
    const auto state = admitted(law, random.stress<Tensor>(kPressure, 0.3));
    REQUIRE(state);
    const auto response = law.response(*state);
    const int mechanisms = std::get<StiffnessForm<Tensor>>(response).mechanisms;
    for (unsigned loading = 0; loading < 1U << mechanisms; ++loading) {
      const Matrix<Tensor> tangent = sim::test::tangent_of(response, loading);
      CHECK((tangent - tangent.transpose()).norm() < 1e-10 * tangent.norm());
      ++checked;
    }
  });
  CHECK(checked >= 6);
}

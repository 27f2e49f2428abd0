// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/finite_driver.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/materials/umat_fixture.hpp"

using namespace triax::sim;
using namespace triax::sim::test;
using Control = MixedControl<Axisymmetric>;

namespace {

/// A law that integrates itself, with a closed form: σ₁ = A (1 − (1 − ε₁/ε_p)²), a peak A at ε_p
/// and softening beyond, σ₃ = K ε₃. Its tangent may be withheld.
class Arch : public Law<Axisymmetric> {
 public:
  explicit Arch(bool tangent = true) : tangent_(tangent) {}
  static constexpr double kPeak = 100e3, kPeakStrain = 0.01, kRadial = 50e6;

  bool finite() const override { return true; }
  bool carries_tension() const override { return true; }
  State start(const Vector<Axisymmetric>& stress, double void_ratio) const override {
    return {stress, void_ratio, Memory::Zero(1)};
  }
  void response(const State&, Response<Axisymmetric>&) const override {}
  FiniteStep<Axisymmetric> integrate(const State& from,
                                     const Vector<Axisymmetric>& strain) const override {
    FiniteStep<Axisymmetric> step;
    step.state = from;
    if (strain.norm() > 0.05) {
      step.failure = "too far";
      step.smaller = true;
      return step;
    }
    const double before = from.memory(0), now = before + strain(0);
    const auto arch = [](double e) { return kPeak * (1 - std::pow(1 - e / kPeakStrain, 2)); };
    step.state.memory(0) = now;
    step.state.stress(0) += arch(now) - arch(before);
    step.state.stress(1) += kRadial * strain(1);
    if (tangent_) {
      step.tangent(0, 0) = 2 * kPeak / kPeakStrain * (1 - now / kPeakStrain);
      step.tangent(1, 1) = kRadial;
    }
    return step;
  }

 private:
  bool tangent_;
};

Control stresses(double axial, double radial) { return Control::stresses({axial, radial}); }

}  // namespace

TEST_CASE("strain under stress control has the accuracy that was asked for") {
  const Arch law;
  const auto start = law.isotropic(50e3, 0.7);
  const auto step = advance_point(law, start, stresses(96e3, 1e3));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.strain_increment(0) == Approx(0.01 * (1 - std::sqrt(0.04))).epsilon(1e-8));
  CHECK(step.strain_increment(1) == Approx(1e3 / Arch::kRadial).epsilon(1e-8));
  CHECK(step.stress_increment(0) == Approx(96e3).epsilon(1e-8));
}

TEST_CASE("a law without a tangent is driven all the same") {
  const Arch law(false);
  const auto step = advance_point(law, law.isotropic(50e3, 0.7), stresses(96e3, 1e3));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.strain_increment(0) == Approx(0.008).epsilon(1e-7));
}

TEST_CASE("stress control of a finite law ends at its peak, and the row is named") {
  const Arch law;
  const auto start = law.isotropic(50e3, 0.7);
  for (const int row : {0, 1}) {
    Control control = stresses(120e3, 1e3);
    if (row == 1) {
      control.stress.row(0).swap(control.stress.row(1));
      std::swap(control.increment(0), control.increment(1));
    }
    const auto step = advance_point(law, start, control);
    CHECK(step.outcome == StepOutcome::lost_control);
    CHECK(step.limiting_variable == row);
    CHECK(step.state.stress(0) == Approx(150e3).epsilon(1e-7));
    CHECK(step.state.memory(0) == Approx(0.01).epsilon(1e-3));
    CHECK(step.done == Approx(100.0 / 120).epsilon(1e-7));
  }
  // Beyond the peak strain control goes on.
  const auto beyond = advance_point(law, start, Control::drained_compression(0.015));
  REQUIRE(beyond.outcome == StepOutcome::accepted);
  CHECK(beyond.state.stress(0) == Approx(125e3).epsilon(1e-9));
}

TEST_CASE("a rate of a finite law is the quotient of a small increment") {
  const Arch law;
  const auto start = law.isotropic(50e3, 0.7);
  const auto at = [&](double strain) {
    return advance_point(law, start, Control::drained_compression(strain)).state;
  };
  const auto rate = point_rate(law, at(0.005), stresses(1, 0));
  REQUIRE(rate.controllable);
  CHECK(rate.strain(0) == Approx(1 / 10e6).epsilon(1e-4));
  CHECK(rate.stress(0) == Approx(1).epsilon(1e-8));
  CHECK(rate.second_order_work() > 0);
  CHECK(point_rate(law, at(0.012), Control::drained_compression(1)).second_order_work() < 0);
  CHECK(point_rate(law, start, stresses(0, 0)).controllable);
  const auto lost = point_rate(law, at(0.01), stresses(1, 0));
  CHECK_FALSE(lost.controllable);
  CHECK(lost.limiting_variable == 0);
}

TEST_CASE("an increment that the law finds too large is cut") {
  const Arch law;
  const auto step = advance_point(law, law.isotropic(50e3, 0.7), Control::drained_compression(0.2));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.strain_increment(0) == Approx(0.2).epsilon(1e-12));
  CHECK(step.steps >= 4);
}

TEST_CASE("conditions that say the same twice are refused for a finite law too") {
  const Arch law;
  Control twice;
  twice.strain << 1, 2, 2, 4;
  twice.increment << 1e-3, 2e-3;
  const auto step = advance_point(law, law.isotropic(100e3, 1.0), twice);
  CHECK(step.outcome == StepOutcome::failed);
  CHECK_FALSE(step.message.empty());
  CHECK_FALSE(point_rate(law, law.isotropic(100e3, 1.0), twice).controllable);
}

TEST_CASE("a load beyond the strength of a UMAT is stopped at the strength") {
  if (!umat_fixture_is_there()) return;
  const Material material = make_umat(umat_fixture());
  const double strength = ConeInCompression(100, 0.02).q * 1e3;
  const auto& law = *material.axisymmetric;
  Control load;  // σ₃ held, q raised
  load.stress << 0, 1, 1, -1 / std::sqrt(2.0);
  load.increment << 0, 2 * strength;
  const auto step = advance_point(law, law.isotropic(100e3, 0.8), load);
  INFO(step.message);
  CHECK(step.outcome == StepOutcome::lost_control);
  CHECK(step.limiting_variable == 1);
  CHECK(step.state.q() == Approx(strength).epsilon(1e-8));
  CHECK(step.done == Approx(0.5).epsilon(1e-8));

  const auto rate = point_rate(law, step.state, load);
  CHECK_FALSE(rate.controllable);
  CHECK(rate.limiting_variable == 1);
  const auto unloading = point_rate(law, step.state, Control::drained_compression(-1));
  REQUIRE(unloading.controllable);
  const double young = 9 * kBulk * kShear / (3 * kBulk + kShear) * 1e3;
  CHECK(unloading.stress(0) == Approx(-young).epsilon(1e-6));
  const auto loading = point_rate(law, step.state, Control::drained_compression(1));
  REQUIRE(loading.controllable);
  CHECK(std::abs(loading.stress(0)) < 1e-4 * young);  // the state stands 1e-9 inside the cone

  const auto& full = *material.tensor;
  const auto tensor = advance_point(full, full.isotropic(100e3, 0.8),
                                    MixedControl<Tensor>::stress_path(strength, 2 * strength));
  CHECK(tensor.outcome == StepOutcome::lost_control);
  CHECK(tensor.state.q() == Approx(kM * tensor.state.p() + kCohesion * 1e3).epsilon(1e-7));
}

TEST_CASE("undrained compression of a UMAT keeps its volume") {
  if (!umat_fixture_is_there()) return;
  const Material material = make_umat(umat_fixture());
  const auto& law = *material.axisymmetric;
  const auto step = advance_point(law, law.isotropic(100e3, 0.8), Control::strain_path(0.01));
  REQUIRE(step.outcome == StepOutcome::accepted);
  // On the cone dq/dε_q = M dp′/dε_q with dε_v = 0: elastic until q = M p₀ + c.
  const double q_first = kM * 100 + kCohesion, elastic = q_first / 3 / kShear;
  const double rate = 3 * kShear * kM * kBulk * kN / (3 * kShear + kM * kBulk * kN);
  CHECK(step.state.q() / 1e3 == Approx(q_first + rate * (0.01 - elastic)).epsilon(1e-5));
  CHECK(step.state.void_ratio == Approx(0.8).epsilon(1e-12));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/elastic.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/random_tensors.hpp"

using namespace triax::sim;
using Control = MixedControl<Axisymmetric>;

namespace {

ElasticParameters linear() { return {60e6, 0.2, 0, 100e3}; }
ElasticParameters elastic_power(double exponent) { return {60e6, 0.2, exponent, 100e3}; }

}  // namespace

TEST_CASE("linear elasticity: drained triaxial compression gives E and nu back") {
  const Elastic<Axisymmetric> law(linear());
  const auto step =
      advance_point(law, law.isotropic(100e3, 0.9), Control::drained_compression(0.004));
  REQUIRE(step.outcome == StepOutcome::accepted);
  CHECK(step.state.q() == Approx(60e6 * 0.004).epsilon(1e-12));
  CHECK(axisymmetric_strain(step.strain_increment).radial == Approx(-0.2 * 0.004).epsilon(1e-12));
}

TEST_CASE("linear elasticity: oedometric compression has the constrained modulus and K0") {
  const Elastic<Tensor> law(linear());
  Vector<Tensor> strain = Vector<Tensor>::Zero();
  strain(0) = 0.001;
  const auto step =
      advance_point(law, law.isotropic(100e3, 0.9), MixedControl<Tensor>::strains(strain));
  const double nu = 0.2, constrained = 60e6 * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  CHECK(step.stress_increment(0) == Approx(constrained * 0.001).epsilon(1e-12));
  CHECK(step.stress_increment(1) == Approx(nu / (1 - nu) * constrained * 0.001).epsilon(1e-12));
  CHECK(step.stress_increment.tail<3>().isZero(0));
  CHECK(step.state.void_ratio == Approx(1.9 * std::exp(-0.001) - 1).epsilon(1e-9));
}

TEST_CASE("linear elasticity carries tension; a power of p' ends at p' = 0, in words") {
  const auto falling = Control::stress_path(-150e3, 0);
  const Elastic<Axisymmetric> straight(linear());
  const auto pulled = advance_point(straight, straight.isotropic(100e3, 0.9), falling);
  CHECK(pulled.outcome == StepOutcome::accepted);
  CHECK(pulled.state.p() == Approx(-50e3));

  const Elastic<Axisymmetric> curved(elastic_power(0.65));
  const auto stopped = advance_point(curved, curved.isotropic(100e3, 0.9), falling);
  CHECK(stopped.outcome == StepOutcome::failed);
  CHECK_THAT(stopped.message, Catch::Contains("p' is not above 0"));
  CHECK(stopped.state.p() > 0);
  CHECK(stopped.state.p() < 1);
  CHECK(stopped.strain_increment.allFinite());
}

TEST_CASE("with a power of p' isotropic compression follows its closed form") {
  // dε_v = dp/K, K = K_ref (p/p_ref)ⁿ: ε_v = (p^(1−n) − p0^(1−n)) p_refⁿ/((1 − n) K_ref)
  const double n = 0.65, k_ref = 60e6 / (3 * (1 - 0.4));
  const Elastic<Axisymmetric> law(elastic_power(n));
  const auto step = advance_point(law, law.isotropic(50e3, 0.9), Control::stress_path(350e3, 0));
  REQUIRE(step.outcome == StepOutcome::accepted);
  const double strain =
      (std::pow(400e3, 1 - n) - std::pow(50e3, 1 - n)) * std::pow(100e3, n) / ((1 - n) * k_ref);
  CHECK(trace<Axisymmetric>(step.strain_increment) == Approx(strain).margin(1e-9));
  CHECK(step.state.void_ratio == Approx(1.9 * std::exp(-strain) - 1).epsilon(1e-9));
}

TEST_CASE("an exponent of one makes ln p' proportional to the volume change") {
  const Elastic<Axisymmetric> law(elastic_power(1));
  const double k_ref = 60e6 / (3 * (1 - 0.4)), volume = 0.003;
  const auto step = advance_point(law, law.isotropic(100e3, 0.9),
                                  Control::strains({volume / 3, std::sqrt(2.0) * volume / 3}));
  CHECK(step.state.p() == Approx(100e3 * std::exp(k_ref / 100e3 * volume)).epsilon(1e-9));
}

TEST_CASE("a cycle of volume and shear does not close where stiffness grows with p'") {
  // Shear at high p', back at low p': what the header calls hypoelastic.
  const Elastic<Axisymmetric> law(elastic_power(0.65));
  auto state = law.isotropic(100e3, 0.9);
  const Vector<Axisymmetric> volume = 1e-3 * identity<Axisymmetric>();
  const Vector<Axisymmetric> shear(1e-3, -std::sqrt(2.0) * 0.5e-3);
  for (const auto& part :
       {volume, shear, Vector<Axisymmetric>(-volume), Vector<Axisymmetric>(-shear)})
    state = advance_point(law, state, Control::strains(part)).state;
  CHECK(state.p() == Approx(100e3).epsilon(1e-9));
  CHECK(state.q() > 10e3);
}

TEST_CASE("elasticity is symmetric, isotropic and the same in both spaces") {
  test::RandomTensors random;
  const Elastic<Tensor> law(elastic_power(0.65));
  const Elastic<Axisymmetric> triaxial(elastic_power(0.65));
  for (int i = 0; i < 30; ++i) {
    const auto stress = random.stress<Tensor>(random.uniform(20e3, 900e3), 0.5);
    const auto state = law.start(stress, 0.9);
    const Matrix<Tensor> tangent = test::tangent_of(law.response(state), 0);
    CHECK((tangent - tangent.transpose()).isZero(1e-6));
    const Matrix<Tensor> turned = rotation(random.turn());
    CHECK((turned * tangent * turned.transpose()).isApprox(tangent, 1e-12));

    const auto narrow = random.stress<Axisymmetric>(200e3, 0.5);
    const auto strain = random.direction<Axisymmetric>();
    const auto a = point_rate(triaxial, triaxial.start(narrow, 0.9), Control::strains(strain));
    const auto t = point_rate(law, law.start(as_tensor(narrow), 0.9),
                              MixedControl<Tensor>::strains(as_tensor(strain)));
    CHECK(as_tensor(a.stress).isApprox(t.stress, 1e-12));
  }
}

TEST_CASE("work is the same in invariants and in components") {
  test::RandomTensors random;
  const Elastic<Axisymmetric> law(linear());
  for (int i = 0; i < 20; ++i) {
    const auto rate = point_rate(law, law.isotropic(100e3, 0.9),
                                 Control::strains(random.direction<Axisymmetric>()));
    const double dp = mean_stress<Axisymmetric>(rate.stress);
    const double dq = deviator_stress<Axisymmetric>(rate.stress);
    const double volumetric = trace<Axisymmetric>(rate.strain);
    const double deviatoric = 2.0 / 3 * deviator_stress<Axisymmetric>(rate.strain);
    CHECK(dp * volumetric + dq * deviatoric == Approx(rate.second_order_work()).epsilon(1e-12));
  }
}

TEST_CASE("parameters without meaning are refused by name") {
  CHECK_THROWS_WITH(Elastic<Tensor>({-1, 0.2, 0, 100e3}), Catch::Contains("young_modulus_kPa"));
  CHECK_THROWS_WITH(Elastic<Tensor>({1e6, 0.5, 0, 100e3}), Catch::Contains("poisson_ratio is 0.5"));
  CHECK_THROWS_WITH(Elastic<Tensor>({1e6, 0.2, -1, 100e3}), Catch::Contains("pressure_exponent"));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/probed_moduli.hpp"

#include <catch2/catch.hpp>

#include "sim/materials/cam_clay.hpp"
#include "sim/materials/elastic.hpp"
#include "sim/point/point_driver.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEMPLATE_TEST_CASE("probing SANISAND gives its closed form", "", Axisymmetric, Tensor) {
  const ProbedModuli<TestType> probed(std::make_shared<Sanisand<Tensor>>(with_h0(kInl2)));
  const SanisandModuli<TestType> closed(with_h0(kInl2));
  for (const double eta : {0.1, 0.4, 0.7}) {
    const auto triaxial = state_at(inl2(), 80, eta, 1.05).stress;
    Vector<TestType> stress;
    if constexpr (TestType::kSize == 2)
      stress = triaxial;
    else
      stress = as_tensor(triaxial);
    Matrix<TestType> p1, m1, p2, m2;
    probed.moduli(probed.start(stress, 1.05), p1, m1);
    closed.moduli(closed.start(stress, 1.05), p2, m2);
    CHECK(p1.isApprox(p2, 1e-9));
    CHECK(m1.isApprox(m2, 1e-9));
  }
}

TEST_CASE("on the axes a shell on a probed law answers as that law; on elasticity it is elastic") {
  CamClayParameters clay;
  clay.compression_slope = 0.1;
  clay.swelling_slope = 0.01;
  clay.critical_stress_ratio = 1;
  clay.poisson_ratio = 0.3;
  const auto base = std::make_shared<CamClay<Tensor>>(clay);
  const Interpolated<Tensor> shell(Interpolation::inl2,
                                   std::make_shared<ProbedModuli<Tensor>>(base));
  // Normally consolidated and sheared: on the yield surface.
  const auto on_yield = advance_point<Tensor>(*base, base->isotropic(200e3, 0.8),
                                              MixedControl<Tensor>::drained_compression(0.01))
                            .state;
  for (int j = 0; j < 3; ++j)
    for (const double sign : {1.0, -1.0}) {
      const auto control =
          MixedControl<Tensor>::stresses(Vector<Tensor>(sign * 1e3 * Vector<Tensor>::Unit(j)));
      const auto a = point_rate<Tensor>(shell, on_yield, control);
      const auto b = point_rate<Tensor>(*base, on_yield, control);
      REQUIRE(a.controllable);
      CHECK(a.strain.isApprox(b.strain, 1e-9));
    }

  ElasticParameters hooke;
  hooke.young_modulus_pa = 20e6;
  hooke.poisson_ratio = 0.25;
  hooke.reference_pressure_pa = 100e3;
  const auto elastic = std::make_shared<Elastic<Tensor>>(hooke);
  const Interpolated<Tensor> linear(Interpolation::inl2,
                                    std::make_shared<ProbedModuli<Tensor>>(elastic));
  const auto start = linear.isotropic(100e3, 0.8);
  const Vector<Tensor> strain = 1e-4 * (Vector<Tensor>() << 1, -2, 0.5, 0, 0, 0).finished();
  const auto a = point_rate<Tensor>(linear, start, MixedControl<Tensor>::strains(strain));
  const auto b = point_rate<Tensor>(*elastic, start, MixedControl<Tensor>::strains(strain));
  CHECK(a.stress.isApprox(b.stress, 1e-10));
}

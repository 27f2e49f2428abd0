// SPDX-License-Identifier: GPL-3.0-or-later
// Elasticity and laws with an associated flow rule have no unstable direction before their limit
// surface: W₂ = dσ:dε = dε:C:dε − λ n:C:dε > 0, since the plastic part cannot take more than the
// projection of the elastic one while the modulus is positive.
#include <catch2/catch.hpp>

#include "sim/materials/cam_clay.hpp"
#include "sim/materials/drucker_prager.hpp"
#include "sim/materials/elastic.hpp"
#include "sim/materials/mohr_coulomb.hpp"
#include "sim/stability/sphere.hpp"
#include "tests/sim/materials/random_tensors.hpp"
#include "tests/sim/stability/stability_states.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

/// Every kind of probe at one state.
template <class MadeLaw2, class MadeLaw3>
void check_law_stable(const MadeLaw2& triaxial, const MadeLaw3& full, double p_kPa, double eta,
                      double e) {
  INFO("p = " << p_kPa << " kPa, eta = " << eta);
  for (const auto kind : {ProbeKind::stress, ProbeKind::strain}) {
    const auto flat = circle_at<Axisymmetric>(triaxial, p_kPa, eta, e, kind);
    CHECK(flat.unanswered == 0);
    CHECK(flat.cones.empty());
    CHECK(flat.least.normalised > 0);
    const auto plane_strain = circle_at<Tensor>(full, p_kPa, eta, e, kind);
    CHECK(plane_strain.unanswered == 0);
    CHECK(plane_strain.least.normalised > 0);
    const auto response = response_at<Tensor>(full, p_kPa, eta, e);
    const Sphere sphere = probe_sphere(*response, kind, 8);
    CHECK(sphere.unanswered == 0);
    CHECK(sphere.least.normalised > 0);
    CHECK(least_of_all_directions(*response, kind, sphere.least, 2).normalised > 0);
  }
}

template <template <class> class SomeLaw, class Parameters>
void check_below(const Parameters& p, double limit_compression, double limit_extension) {
  const SomeLaw<Axisymmetric> triaxial(p);
  const SomeLaw<Tensor> full(p);
  RandomTensors random;
  for (int i = 0; i < 6; ++i)
    check_law_stable(triaxial, full, random.uniform(20, 800),
                     random.uniform(-limit_extension, limit_compression), random.uniform(0.6, 1.1));
  for (const double eta : {0.0, 0.999 * limit_compression, -0.999 * limit_extension})
    check_law_stable(triaxial, full, 100, eta, 0.8);
}

}  // namespace

TEST_CASE("elasticity has no unstable direction anywhere") {
  ElasticParameters p;
  p.young_modulus_pa = 40e6;
  p.poisson_ratio = 0.3;
  p.reference_pressure_pa = 100e3;
  check_below<Elastic>(p, 3, 1.5);
}

TEST_CASE("Cam-Clay on its yield surface has no unstable direction below M") {
  CamClayParameters p;
  p.compression_slope = 0.1;
  p.swelling_slope = 0.01;
  p.critical_stress_ratio = 1.0;
  p.poisson_ratio = 0.3;
  check_below<CamClay>(p, 0.97, 0.97);
}

TEST_CASE("associated Drucker-Prager and Mohr-Coulomb have none inside their surface") {
  const double phi = radians(30);
  const double compression = stress_ratio_at_friction_angle(phi);
  DruckerPragerParameters dp;
  dp.young_modulus_pa = 30e6;
  dp.poisson_ratio = 0.25;
  dp.reference_pressure_pa = 100e3;
  dp.friction_angle = dp.dilation_angle = phi;
  check_below<DruckerPrager>(dp, 0.99 * compression, 0.99 * compression);
  MohrCoulombParameters mc;
  mc.young_modulus_pa = 30e6;
  mc.poisson_ratio = 0.25;
  mc.reference_pressure_pa = 100e3;
  mc.friction_angle = mc.dilation_angle = phi;
  check_below<MohrCoulomb>(mc, 0.99 * compression, 6 * std::sin(phi) / (3 + std::sin(phi)) * 0.99);
}

TEST_CASE("a cone without flow along its normal is unstable in some direction: the contrast") {
  // The same Cam-Clay machinery with another law: SANISAND, not associated.
  const Sanisand<Axisymmetric> law(s28_general());
  CHECK_FALSE(circle_at<Axisymmetric>(law, 70, 0.7, 1.086).cones.empty());
}

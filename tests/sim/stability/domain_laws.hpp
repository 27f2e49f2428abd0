// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "sim/materials/cam_clay.hpp"
#include "sim/materials/drucker_prager.hpp"
#include "sim/materials/elastic.hpp"
#include "sim/materials/mohr_coulomb.hpp"
#include "sim/materials/sanisand.hpp"
#include "tests/sim/materials/hypoplastic_sets.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"
#include "tests/sim/materials/norsand_sets.hpp"

// A law of every kind of form, for tests that hold for all of them.
namespace triax::sim::test {

struct DomainLaw {
  std::string name;
  Material material;
  double void_ratio;
};

template <template <class> class SomeLaw, class Parameters>
Material both(const Parameters& p) {
  return {std::make_shared<SomeLaw<Axisymmetric>>(p), std::make_shared<SomeLaw<Tensor>>(p), {}, {}};
}

inline constexpr double kThirtyDegrees = std::numbers::pi / 6;

inline ElasticParameters elasticity() {
  ElasticParameters p;
  p.young_modulus_pa = 50e6;
  p.poisson_ratio = 0.2;
  p.reference_pressure_pa = 100e3;
  return p;
}

/// φ = 30°, with that angle of dilation.
template <class Parameters>
Parameters frictional(double dilation_angle) {
  Parameters p;
  static_cast<ElasticParameters&>(p) = elasticity();
  p.friction_angle = kThirtyDegrees;
  p.dilation_angle = dilation_angle;
  return p;
}

inline CamClayParameters clay() {
  CamClayParameters p;
  p.critical_stress_ratio = 1.2;
  p.compression_slope = 0.2;
  p.swelling_slope = 0.02;
  p.poisson_ratio = 0.3;
  return p;
}

inline Material interpolated(Interpolation kind, double h0) {
  return {std::make_shared<Interpolated<Axisymmetric>>(law<Axisymmetric>(kind, h0)),
          std::make_shared<Interpolated<Tensor>>(law<Tensor>(kind, h0)),
          {},
          {}};
}

inline std::vector<DomainLaw> domain_laws() {
  return {
      {"elastic", both<Elastic>(elasticity()), 1.0},
      {"Drucker-Prager", both<DruckerPrager>(frictional<DruckerPragerParameters>(0.1)), 1.0},
      {"Mohr-Coulomb", both<MohrCoulomb>(frictional<MohrCoulombParameters>(0.1)), 1.0},
      {"Cam-clay", both<CamClay>(clay()), 1.0},
      {"SANISAND", both<Sanisand>(s28_general()), 1.05},
      {"hypoplastic", both<Hypoplastic>(hostun_moist_tamped()), 0.95},
      {"intergranular", both<Hypoplastic>(with_intergranular_strain(hostun_moist_tamped())), 0.95},
      {"NorSand", {std::make_shared<NorSand>(nerlerk_drained()), {}, {}, {}}, 0.8},
      {"INL2", interpolated(Interpolation::inl2, kInl2), 1.086},
      {"octolinear", interpolated(Interpolation::octolinear, kOcto), 1.086},
  };
}

}  // namespace triax::sim::test

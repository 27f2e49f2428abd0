// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "lab/results/reading.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {

/// What reduction makes of one reading. SI, compression positive, strains since the start of shear
/// (since the start of the record before that). A value that cannot be known is NaN, null outside.
struct State {
  std::int64_t reading = 0;
  double time_s = kMissing;
  int stage = 1;
  sim::AxisymmetricStrain strain{kMissing, kMissing};  ///< ε₁, and (ε_v − ε₁)/2
  double volumetric_strain = kMissing;                 ///< −dV/V_c, as measured
  double void_ratio = kMissing;
  double area_m2 = kMissing;                                     ///< current, right cylinder
  sim::AxisymmetricStress effective_stress{kMissing, kMissing};  ///< σ₁′, σ₃′
  double pore_pressure = kMissing;
  double p_eff = kMissing;
  double q = kMissing;
  double cycle = kMissing;  ///< as the logger counts

  double eta() const { return q / p_eff; }
  double phi_mob_rad() const { return sim::mobilised_friction_angle(eta()); }
};

}  // namespace triax::lab

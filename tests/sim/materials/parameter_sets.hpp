// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/materials/sanisand.hpp"

// The sets of the published check numbers; lab/materials holds the same as data.
namespace triax::sim::test {

inline SanisandParameters toyoura() {
  SanisandParameters p;
  p.shear_modulus_factor = 125;
  p.poisson_ratio = 0.05;
  p.critical_stress_ratio = 1.25;
  p.extension_ratio = 0.712;
  p.critical_void_ratio = 0.934;
  p.critical_slope = 0.019;
  p.critical_exponent = 0.7;
  p.yield_radius = 0.01;
  p.hardening_factor = 7.05;
  p.hardening_void_ratio_factor = 0.968;
  p.bounding_exponent = 1.1;
  p.dilatancy_factor = 0.704;
  p.dilatancy_exponent = 3.5;
  p.fabric_limit = 4;
  p.fabric_rate = 600;
  p.atmospheric_pressure_pa = 100e3;
  return p;
}

inline SanisandParameters s28_general() {
  SanisandParameters p;
  p.shear_modulus_factor = 60;
  p.poisson_ratio = 0.10;
  p.critical_stress_ratio = 1.2872;
  p.extension_ratio = 0.70;
  p.critical_void_ratio = 1.0;
  p.critical_slope = 0.09;
  p.critical_exponent = 0.28;
  p.yield_radius = 0.01;
  p.hardening_factor = 1.224;
  p.hardening_void_ratio_factor = 0.3;
  p.bounding_exponent = 0.5;
  p.dilatancy_factor = 1.0;
  p.dilatancy_exponent = 1.0;
  p.fabric_limit = 4;
  p.fabric_rate = 600;
  p.atmospheric_pressure_pa = 100e3;
  return p;
}

/// The variant with which the multiaxial code was run against the triaxial form.
inline SanisandParameters s28_variant() {
  SanisandParameters p = s28_general();
  p.hardening_factor = 1.5;
  p.hardening_void_ratio_factor = 0.5;
  p.dilatancy_exponent = 0.5;
  p.fabric_limit = 0;
  return p;
}

}  // namespace triax::sim::test

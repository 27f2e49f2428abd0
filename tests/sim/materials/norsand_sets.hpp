// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/materials/norsand.hpp"

// The sets of the published check numbers; lab/materials holds the same as data.
namespace triax::sim::test {

/// Nerlerk 270 of the authors' workbook, undrained.
inline NorSandParameters nerlerk() {
  NorSandParameters p;
  p.critical_stress_ratio = 1.45;
  p.volumetric_coupling = 0.43;
  p.state_dilatancy = 3.4;
  p.hardening_modulus = 40;
  p.shear_modulus_pa = 71500e3;
  p.shear_modulus_pressure_pa = 500e3;
  p.shear_modulus_exponent = 0.4;
  p.poisson_ratio = 0.15;
  p.critical_void_ratio = 0.875;
  p.critical_slope = 0.020869565;
  p.pore_fluid_bulk_modulus_pa = 1e9;
  return p;
}

inline NorSandParameters nerlerk_drained() {
  NorSandParameters p = nerlerk();
  p.hardening_modulus = 50;
  p.pore_fluid_bulk_modulus_pa = 0;
  return p;
}

/// Hostun S28, moist tamped, undrained.
inline NorSandParameters hostun_norsand() {
  NorSandParameters p;
  p.critical_stress_ratio = 1.2872;
  p.volumetric_coupling = 0.2;
  p.state_dilatancy = 3.5;
  p.hardening_modulus = 100;
  p.shear_modulus_pa = 40e6;
  p.shear_modulus_pressure_pa = 100e3;
  p.shear_modulus_exponent = 0.5;
  p.poisson_ratio = 0.2;
  p.critical_void_ratio = 1.0;
  p.critical_slope = 0.09;
  p.critical_exponent = 0.28;
  p.critical_pressure_pa = 100e3;
  p.pore_fluid_bulk_modulus_pa = 1e9;
  return p;
}

}  // namespace triax::sim::test

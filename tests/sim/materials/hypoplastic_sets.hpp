// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/materials/hypoplastic.hpp"

// The sets of the published check numbers; lab/materials holds the same as data.
namespace triax::sim::test {

inline HypoplasticParameters hostun_hg99() {
  HypoplasticParameters p;
  p.critical_friction_angle = radians(31);
  p.granulate_hardness_pa = 1e9;
  p.pressure_exponent = 0.29;
  p.densest_void_ratio = 0.61;
  p.critical_void_ratio = 0.96;
  p.loosest_void_ratio = 1.09;
  p.peak_exponent = 0.13;
  p.stiffness_exponent = 2;
  return p;
}

inline HypoplasticParameters hostun_schranz() {
  HypoplasticParameters p = hostun_hg99();
  p.critical_friction_angle = 0.576;
  p.densest_void_ratio = 0.63;
  p.critical_void_ratio = 1.00;
  p.loosest_void_ratio = 1.15;
  return p;
}

inline HypoplasticParameters hostun_moist_tamped() {
  HypoplasticParameters p = hostun_hg99();
  p.critical_friction_angle = radians(32);
  p.densest_void_ratio = 0.656;
  p.critical_void_ratio = 1.00;
  p.loosest_void_ratio = 1.20;
  p.peak_exponent = 0.60;
  return p;
}

/// The same with intergranular strain, which the structure's own values describe but for R.
inline HypoplasticParameters with_intergranular_strain(HypoplasticParameters p) {
  p.intergranular_range = 1e-4;
  return p;
}

}  // namespace triax::sim::test

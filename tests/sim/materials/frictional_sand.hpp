// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <numbers>

// The sand of the tests of cones and pyramids: one angle of friction, whichever surface it is put
// into.
namespace triax::sim::test {

inline constexpr double kDegree = std::numbers::pi / 180;

template <class Parameters>
Parameters frictional_sand(double dilation_deg, double cohesion_pa) {
  Parameters p;
  p.young_modulus_pa = 30e6;
  p.poisson_ratio = 0.25;
  p.reference_pressure_pa = 100e3;
  p.friction_angle = 34 * kDegree;
  p.cohesion_pa = cohesion_pa;
  p.dilation_angle = dilation_deg * kDegree;
  return p;
}

}  // namespace triax::sim::test

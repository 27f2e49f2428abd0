// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <numbers>

#include "sim/point/path.hpp"

// Segments that several tests of paths use.
namespace triax::sim::test {

/// Of the second component of stress, which is √2 times the radial one.
inline constexpr double kRadial = 1 / std::numbers::sqrt2;

/// Axial strain at constant cell pressure, undrained.
inline Segment<Axisymmetric> undrained_compression(double axial_strain) {
  Segment<Axisymmetric> segment;
  segment.labels = {"axial_strain", "radial_stress_kPa"};
  segment.conditions.strain(0, 0) = 1;
  segment.conditions.stress(1, 1) = kRadial;
  segment.conditions.increment << axial_strain, 0;
  segment.undrained = true;
  return segment;
}

}  // namespace triax::sim::test

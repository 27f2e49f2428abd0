// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Paths along which the tests of NorSand look for its peak.
#include <catch2/catch.hpp>

#include "sim/materials/norsand.hpp"
#include "sim/point/point_driver.hpp"

namespace triax::sim::test {

using NorSandState = PointState<Axisymmetric>;

inline NorSandState loose(const NorSand& law, double p0_kPa, double psi) {
  return law.isotropic(p0_kPa * 1e3, psi + law.critical_void_ratio(p0_kPa * 1e3));
}

/// Undrained with the compressible water of the workbook: dε_v + dp′/K_w = 0.
inline MixedControl<Axisymmetric> undrained_with_water(double axial_strain, double fluid_pa) {
  MixedControl<Axisymmetric> c = MixedControl<Axisymmetric>::strain_path(axial_strain);
  c.stress.row(1) = identity<Axisymmetric>().transpose() / (3 * fluid_pa);
  return c;
}

struct Peak {
  NorSandState state;
  double strain = 0;
};

/// The converged undrained peak, in small increments and halving the last.
template <class Path>
Peak peak_on(const NorSand& law, NorSandState state, Path path) {
  const auto rising = [&](const NorSandState& at) {
    return deviator_stress<Axisymmetric>(point_rate<Axisymmetric>(law, at, path(1e-4)).stress) > 0;
  };
  const auto advanced = [&](const NorSandState& from, double strain) {
    const auto step = advance_point<Axisymmetric>(law, from, path(strain));
    REQUIRE(step.outcome == StepOutcome::accepted);
    return step.state;
  };
  for (int i = 0; i < 1000; ++i) {
    const NorSandState next = advanced(state, 1e-4);
    if (rising(next)) {
      state = next;
      continue;
    }
    double low = 0, high = 1e-4;
    while (high - low > 1e-12)
      (rising(advanced(state, 0.5 * (low + high))) ? low : high) = 0.5 * (low + high);
    return {advanced(state, low), i * 1e-4 + low};
  }
  FAIL("no peak");
  return {};
}

}  // namespace triax::sim::test

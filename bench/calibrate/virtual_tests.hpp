// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tests whose soil is a law with known parameters, with the noise of instruments.
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "src/study/calibrate/computed_path.hpp"
#include "src/study/calibrate/search_space.hpp"

namespace triax::bench {

struct VirtualTest {
  study::Imposed imposed = study::Imposed::undrained;
  double p_eff_kPa = 100, void_ratio = 0.9;
};

/// Standard deviations of single values; 0: exact. Strains are plain numbers.
struct InstrumentNoise {
  double stress_kPa = 0, strain = 0;
};

/// A test of this material to an axial strain of 15 %, with so many readings, closer together at
/// the start; it ends where the law refuses to go on. Throws std::invalid_argument where that is at
/// once.
inline study::MeasuredPath virtual_path(const lab::MaterialSet& set, const VirtualTest& test,
                                        const InstrumentNoise& noise, std::mt19937_64& dice,
                                        int readings = 300) {
  using study::Imposed;
  study::MeasuredPath path{.name = fmt::format("{} {:g} kPa e {:g}", to_string(test.imposed),
                                               test.p_eff_kPa, test.void_ratio),
                           .simulated = true,
                           .imposed = test.imposed,
                           .void_ratio = test.void_ratio};
  path.start.p_eff = test.p_eff_kPa * 1e3;
  for (int k = 1; k <= readings; ++k) {
    study::PathKnot knot;
    knot.axial_strain = 0.15 * std::pow(static_cast<double>(k) / readings, 2);
    knot.p_eff = path.start.p_eff;  // drained: the radial stress stays
    path.knots.push_back(knot);
  }
  const auto law =
      set.law->make(study::for_drainage(set.parameters, *set.law, test.imposed), {}).axisymmetric;
  const auto computed = study::drive(*law, path, {.tolerance = 1e-8, .step_limit = 20000});
  std::normal_distribution<double> stress(0, noise.stress_kPa * 1e3 + 1e-300);
  std::normal_distribution<double> strain(0, noise.strain + 1e-300);
  std::vector<study::ShearReading> measured;
  for (const auto& knot : computed.knots) {
    const double q = knot.q + stress(dice), radial_noise = stress(dice);
    // What is imposed on a drained test is its radial stress, which a controller holds.
    const double p =
        test.imposed == Imposed::drained ? path.start.p_eff + q / 3 : knot.p_eff + radial_noise;
    measured.push_back(
        {knot.axial_strain,
         test.imposed == Imposed::undrained ? 0 : knot.volumetric_strain + strain(dice), p, q});
  }
  // The peak of a drained test is a failure and no collapse.
  if (test.imposed != Imposed::drained) path.onset_eta = study::onset_eta(*law, path);
  study::lay_knots(path, measured);
  return path;
}

}  // namespace triax::bench

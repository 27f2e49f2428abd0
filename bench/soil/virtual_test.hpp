// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "bench/soil/campaign.hpp"
#include "bench/soil/sands.hpp"

namespace triax::bench {

struct TestPlan {
  bool undrained = false, extension = false;
  double p_eff_pa = 100e3, void_ratio = 0.9, axial_strain = 0.2;  ///< of the largest
};

/// True states over the path, as far as the law goes.
std::vector<lab::State> true_states(const sim::Law<sim::Axisymmetric>& law, const TestPlan& plan);

/// What an apparatus makes of them: a specimen of 140 mm by 70 mm, load cell, cell pressure, pore
/// pressure, LVDT and volume read through the transducers (their non-linearities times
/// `calibration`, −1 to 1 each), and reduced again. `spoilt` puts 15 % on the load cell, or 25 kPa
/// on the zero of the cell pressure.
std::vector<lab::State> measured_states(
    const std::vector<lab::State>& truth, const Transducers& transducers,
    const std::array<double, lab::kRawQuantityCount>& calibration, std::uint64_t seed,
    Spoilt spoilt);

}  // namespace triax::bench

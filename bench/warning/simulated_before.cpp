// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/simulated_before.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "bench/warning/alarm_trial.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::bench {
namespace {

constexpr std::uint64_t kFirstChoice = 20;  ///< those below are taken

/// Number `k` of the seed's numbers of normal distribution.
double normal(std::uint64_t seed, std::uint64_t k) {
  const double u = std::max(choice(seed, kFirstChoice + 2 * k), 1e-12);
  return std::sqrt(-2 * std::log(u)) *
         std::cos(2 * std::numbers::pi * choice(seed, kFirstChoice + 2 * k + 1));
}

/// As it is where the law does not take the numbers.
void as_calibrated(lab::MaterialSet& set, std::uint64_t seed) {
  sim::ParameterSet parameters = set.parameters;
  std::uint64_t k = 1;
  for (auto& [key, value] : parameters.numbers)
    value *= 1 + SimulatedBefore::kParameter * normal(seed, k++);
  try {
    set.material = set.law->make(
        parameters, [](const std::string& name) { return lab::find_material(name).material; });
    set.parameters = std::move(parameters);
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace

SimulatedBefore simulated_before(const Subject& subject, std::uint64_t seed) {
  Instruments instruments{};
  lab::Programme programme = varied_for_alarm(subject, seed, instruments);
  programme.void_ratio += SimulatedBefore::kVoidRatio * normal(seed, 0);
  as_calibrated(programme.material, seed);
  for (lab::Transducer& t : programme.transducers) t.noise_rms = 0, t.step = 0;
  for (lab::Stage& stage : programme.stages)
    for (const lab::Stage& as_written : subject.programme.stages)
      if (stage.name == as_written.name)
        stage.logging.interval_s =
            std::min(stage.logging.interval_s, as_written.logging.interval_s);
  lab::VirtualRig rig(programme, seed);
  std::vector<lab::Forecast> forecasts;
  lab::SessionListener listener;
  listener.foreseen = [&](const lab::Forecast& one) { forecasts.push_back(one); };
  const lab::TestSummary summary = lab::run_session(rig, {}, {listener});
  SimulatedBefore before;
  if (const auto& truth = summary.truth; truth && truth->lost_sustainability)
    before.eta = *truth->q_pa / *truth->p_eff_pa;
  before.said = lab::earlier_test(rig.header(), summary, forecasts);
  return before;
}

}  // namespace triax::bench

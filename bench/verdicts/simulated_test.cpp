// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/verdicts/simulated_test.hpp"

#include <algorithm>

#include "lab/measured/path_sampler.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::bench {

std::optional<SimulatedTest> simulate(const Subject& subject, std::uint64_t seed) {
  lab::VirtualRig rig(varied(subject, seed), seed);
  SimulatedTest test;
  lab::SessionListener listener;
  listener.scanned = [&](const lab::Reading& reading, const lab::State& state) {
    test.readings.push_back(reading);
    test.states.push_back(state);
  };
  const lab::TestSummary summary = lab::run_session(rig, {}, {listener});
  test.header = rig.header();
  test.header.guesses.clear();
  const auto is_shear = [&](const lab::Reading& reading) {
    return lab::is_watched(test.header.stage(reading.stage));
  };
  test.shear = static_cast<std::size_t>(std::ranges::find_if(test.readings, is_shear) -
                                        test.readings.begin());
  const bool lost = summary.truth && summary.truth->lost_sustainability;
  if (lost != subject.collapses) return std::nullopt;
  if (!lost) return test;
  const auto at = std::ranges::find_if(test.readings, [&](const lab::Reading& reading) {
    return reading.time_s >= *summary.truth->time_s;
  });
  if (at == test.readings.end()) return std::nullopt;
  test.lost = static_cast<std::size_t>(at - test.readings.begin());
  return test;
}

}  // namespace triax::bench

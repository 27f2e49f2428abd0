// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/size_bins.hpp"

#include <algorithm>
#include <cmath>

#include "sim/grains/state/grain_measures.hpp"

namespace triax::lab {
namespace {

void measure_error(const sim::GrainState& state, SizeBins& bins) {
  double squares = 0;
  std::int64_t contacts = 0;
  for (const sim::GrainContact& c : sim::contacts_of(state)) {
    if (c.j < 0) continue;
    const double exact = sim::normal_stiffness(state.law, state.grains[c.i].radius,
                                               state.grains[c.j].radius),
                 binned = sim::normal_stiffness(state.law, bins.radius_m[bins.of[c.i]],
                                                bins.radius_m[bins.of[c.j]]);
    const double error = std::abs(binned / exact - 1);
    bins.stiffness_error_most = std::max(bins.stiffness_error_most, error);
    squares += error * error;
    ++contacts;
  }
  if (contacts > 0) bins.stiffness_error_rms = std::sqrt(squares / static_cast<double>(contacts));
}

}  // namespace

SizeBins size_bins(const sim::GrainState& state, int count) {
  const auto smaller = [](const sim::Grain& a, const sim::Grain& b) { return a.radius < b.radius; };
  const auto [least, most] = std::minmax_element(state.grains.begin(), state.grains.end(), smaller);
  const double from = std::log(least->radius), width = (std::log(most->radius) - from) / count;
  std::vector<std::int32_t> of;
  std::vector<double> sum(count);
  std::vector<std::int32_t> members(count);
  for (const sim::Grain& g : state.grains) {
    const double place = width > 0 ? (std::log(g.radius) - from) / width : 0;
    const auto bin = static_cast<std::int32_t>(std::clamp(place, 0.0, count - 1.0));
    of.push_back(bin);
    sum[bin] += std::log(g.radius);
    ++members[bin];
  }
  SizeBins bins;
  std::vector<std::int32_t> kept(count);
  for (int b = 0; b < count; ++b) {
    if (members[b] == 0) continue;
    kept[b] = static_cast<std::int32_t>(bins.radius_m.size());
    bins.radius_m.push_back(std::exp(sum[b] / members[b]));
  }
  for (const std::int32_t b : of) bins.of.push_back(kept[b]);
  measure_error(state, bins);
  return bins;
}

}  // namespace triax::lab

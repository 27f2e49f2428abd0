// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/faulty_channel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lab/devices/noise.hpp"

namespace triax::lab {
namespace {

/// Streams of spikes, apart from those of noise (one a channel).
constexpr std::uint64_t kSpikeStreams = 1U << 16U;
/// One spike in so many readings, at a random place among them.
constexpr std::uint64_t kSpikeEvery = 32;

}  // namespace

FaultyChannel::FaultyChannel(std::vector<Fault> faults, const Transducer& transducer,
                             std::uint64_t seed, std::uint64_t stream)
    : unit_(transducer.unit),
      step_(transducer.calibration.empty() ? transducer.step : 0),
      lowest_si_(std::min(end_of_range_si(transducer, -1), end_of_range_si(transducer))),
      highest_si_(std::max(end_of_range_si(transducer, -1), end_of_range_si(transducer))),
      seed_(seed),
      stream_(stream) {
  set_faults(std::move(faults));
}

void FaultyChannel::set_faults(std::vector<Fault> faults) {
  faults_ = std::move(faults);
  longest_latency_s_ = 0;
  for (const Fault& fault : faults_)
    if (fault.kind == FaultKind::latency)
      longest_latency_s_ = std::max(longest_latency_s_, fault.size);
}

double FaultyChannel::spike_of(const Fault& fault) const {
  const std::uint64_t block = state_.passed / kSpikeEvery;
  const std::uint64_t stream = kSpikeStreams + stream_;
  const double place =
      static_cast<double>(kSpikeEvery) * standard_uniform(seed_, stream, 2 * block);
  if (state_.passed % kSpikeEvery != static_cast<std::uint64_t>(place)) return 0;
  return standard_uniform(seed_, stream, 2 * block + 1) < 0.5 ? -fault.size : fault.size;
}

double FaultyChannel::disturbed(double si, double time_s) const {
  double added_si = 0;
  for (const Fault& fault : faults_) {
    if (!fault.active(time_s)) continue;
    if (fault.kind == FaultKind::drift) added_si += fault.size * (time_s - fault.from_s);
    if (fault.kind == FaultKind::spike) added_si += spike_of(fault);
    if (fault.kind == FaultKind::open_circuit)
      return std::isfinite(highest_si_) ? highest_si_ : std::numeric_limits<double>::quiet_NaN();
  }
  if (added_si == 0) return si;
  double field = sim::to_field(si + added_si, unit_);
  if (step_ > 0) field = std::round(field / step_) * step_;
  return std::clamp(sim::to_si(field + 0.0, unit_), lowest_si_, highest_si_);
}

void FaultyChannel::keep(double si, double time_s) {
  const double spacing_s = longest_latency_s_ / 60 * (1 - 1e-9);
  const State::Kept& newest = state_.ring[(state_.next + kKept - 1) % kKept];
  if (state_.kept > 0 && time_s - newest.time_s < spacing_s) return;
  state_.ring[state_.next] = {time_s, si};
  state_.next = (state_.next + 1) % kKept;
  state_.kept = std::min(state_.kept + 1, kKept);
}

/// The newest that is kept of that time or before it; the oldest where there is none.
double FaultyChannel::as_of(double time_s) const {
  const double latest = time_s + 1e-9 * longest_latency_s_;
  std::size_t place = state_.next;
  for (std::size_t i = 0; i < state_.kept; ++i) {
    place = (place + kKept - 1) % kKept;
    if (state_.ring[place].time_s <= latest) break;
  }
  return state_.ring[place].si;
}

double FaultyChannel::pass(double si, double time_s) {
  double value = disturbed(si, time_s);
  if (longest_latency_s_ > 0) keep(value, time_s);
  double latency_s = 0;
  bool is_stuck = false, dropped = false;
  for (const Fault& fault : faults_) {
    if (!fault.active(time_s)) continue;
    if (fault.kind == FaultKind::latency) latency_s = std::max(latency_s, fault.size);
    is_stuck = is_stuck || fault.kind == FaultKind::stuck;
    dropped = dropped || fault.kind == FaultKind::drop_out;
  }
  if (latency_s > 0) value = as_of(time_s - latency_s);
  if (is_stuck) value = state_.last_given_si.value_or(value);
  if ((!is_stuck && !dropped) || !state_.last_given_si) state_.last_given_si = value;
  ++state_.passed;
  if (dropped) value = std::numeric_limits<double>::quiet_NaN();
  state_.saturated = value <= lowest_si_ || value >= highest_si_;
  return value;
}

}  // namespace triax::lab

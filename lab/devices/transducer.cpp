// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/transducer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/devices/first_order.hpp"
#include "lab/devices/noise.hpp"

namespace triax::lab {
namespace {

/// Moves lag and hysteresis from the last look to `time_s`, when the true value is `field`.
void follow(const Transducer& t, TransducerState& state, double field, double time_s) {
  if (state.lagged) {
    state.lagged = first_order(*state.lagged, state.true_field, field, time_s - state.time_s,
                               t.time_constant_s);
  } else {
    state.lagged = field;
    state.hysteresis.rest_at(field);
  }
  state.sensed = state.hysteresis.follow(*state.lagged, t.hysteresis, t.range);
  state.true_field = field;
  state.time_s = time_s;
}

double bent(const Transducer& t, double field) {
  const double ratio = t.nonlinearity != 0 ? std::abs(field) / t.range : 1;
  if (ratio >= 1) return field;
  return field + std::copysign(4 * t.nonlinearity * ratio * (1 - ratio), field);
}

double calibrated(const Transducer& t, double field) {
  if (t.calibration.empty()) return field;
  const double signal_mV = field / t.range * t.sensitivity_mV;
  double value = 0;
  for (auto c = t.calibration.rbegin(); c != t.calibration.rend(); ++c)
    value = value * signal_mV + *c;
  return value;
}

/// From x₂ to the reading.
TransducerReading converted(const Transducer& t, double field, double time_s, double normal) {
  field = bent(t, field);
  field += t.offset + t.drift_per_hour * (time_s / 3600) + t.noise_rms * normal;
  if (t.step > 0) field = std::round(field / t.step) * t.step;
  TransducerReading reading;
  if (t.range > 0 && std::abs(field) > t.range) {
    field = std::copysign(t.range, field);
    reading.saturated = true;
  }
  // −0 would be written as "-0".
  reading.si = sim::to_si(calibrated(t, field) + 0.0, t.unit);
  return reading;
}

void sample(const Transducer& t, TransducerState& state, std::uint64_t seed, std::uint64_t stream) {
  const double normal =
      t.noise_rms > 0 ? standard_normal(seed, stream, static_cast<std::uint64_t>(state.samples))
                      : 0;
  const TransducerReading reading = converted(t, state.sensed, state.time_s, normal);
  state.held_si = reading.si;
  state.saturated = reading.saturated;
  ++state.samples;
}

/// Number of the sample held at that time; a time that is a multiple but for round-off is one.
std::int64_t due_sample(const Transducer& t, double time_s) {
  return static_cast<std::int64_t>(std::floor(time_s / t.sampling_interval_s * (1 + 1e-12)));
}

}  // namespace

double converter_step(double range, int bits) { return std::ldexp(range, 1 - bits); }

double end_of_range_si(const Transducer& transducer, int end) {
  if (transducer.range == 0) return end * std::numeric_limits<double>::infinity();
  return sim::to_si(calibrated(transducer, end * transducer.range), transducer.unit);
}

TransducerReading look(const Transducer& transducer, TransducerState& state, double true_si,
                       double time_s, std::uint64_t seed, std::uint64_t stream) {
  const double field = sim::to_field(true_si, transducer.unit);
  const double interval = transducer.sampling_interval_s;
  const bool first = !state.lagged;
  if (interval == 0 || first) {
    follow(transducer, state, field, time_s);
    if (interval > 0) state.samples = due_sample(transducer, time_s);
    sample(transducer, state, seed, stream);
    return {state.held_si, state.saturated};
  }
  const std::int64_t due = due_sample(transducer, time_s);
  if (due >= state.samples) {
    const double due_s = std::clamp(static_cast<double>(due) * interval, state.time_s, time_s);
    const double way = time_s > state.time_s ? (due_s - state.time_s) / (time_s - state.time_s) : 1;
    const double then = way == 1 ? field : state.true_field + way * (field - state.true_field);
    follow(transducer, state, then, due_s);
    state.samples = due;
    sample(transducer, state, seed, stream);
  }
  follow(transducer, state, field, time_s);
  return {state.held_si, state.saturated};
}

TransducerReading read(const Transducer& transducer, double true_si, double normal) {
  return converted(transducer, sim::to_field(true_si, transducer.unit), 0, normal);
}

}  // namespace triax::lab

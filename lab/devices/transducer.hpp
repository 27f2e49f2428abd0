// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/devices/hysteresis.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {

/// An instrument, its amplifier and its converter. Everything is in the unit of the field; what is
/// 0 is absent, and with all of it absent the true value passes through to the bit. The chain:
///
///   x₁  lag            τ ẋ₁ = x − x₁, the true value taken as linear between two looks
///   x₂  hysteresis     what an elastic element remembers (hysteresis.hpp)
///   x₃  non-linearity  x₂ + 4 n r (1 − r) sign x₂,  r = |x₂|/range ≤ 1: 0 at both ends, at most n
///   x₄  zero           x₃ + offset + drift t + noise_rms · (standard normal number of the sample)
///   s   converter      x₄ rounded to the step and held within ±range
///   reading            s, or c₀ + c₁ v + c₂ v² ... of the signal v = s · sensitivity_mV/range
///
/// The electrical signal is proportional to x₄, so that the converter may act on either of them.
/// The polynomial is the user's: it can undo the non-linearity, or be a wrong one.
struct Transducer {
  sim::Unit unit;
  double range = 0;  ///< full scale, both signs; 0: unlimited
  double step = 0;   ///< of the converter; 0: continuous
  double noise_rms = 0;
  double offset = 0;
  double drift_per_hour = 0;        ///< of the zero, linear in test time
  double time_constant_s = 0;       ///< τ
  double hysteresis = 0;            ///< h: half of what rising and falling differ over full scale
  double nonlinearity = 0;          ///< n, of either sign; needs a range
  double sensitivity_mV = 0;        ///< electrical output at full scale; a polynomial needs it
  std::vector<double> calibration;  ///< c₀, c₁...: of mV; empty: the linear one
  double sampling_interval_s = 0;   ///< samples at its multiples, held between; 0: at every look
};

/// What a transducer remembers; plain values, to be kept from look to look.
struct TransducerState {
  std::optional<double> lagged;  ///< x₁
  Hysteresis hysteresis;
  double sensed = 0;         ///< x₂
  double true_field = 0;     ///< x at the last look
  double time_s = 0;         ///< of the last look
  std::int64_t samples = 0;  ///< number of the next sample
  double held_si = 0;        ///< the last sample
  bool saturated = false;    ///< of the last sample
  bool operator==(const TransducerState&) const = default;
};

/// Step of a converter of that many bits over −range to +range.
double converter_step(double range, int bits);

/// What it reads at the end of the converter, +range or (end = −1) −range, SI; infinite where it
/// has no range.
double end_of_range_si(const Transducer& transducer, int end = 1);

struct TransducerReading {
  double si = 0;  ///< always to_si of a number in the unit of the field, so that a file keeps it
  bool saturated = false;  ///< the range ended the reading
};

/// Looks at the true value at test time `time_s`, which never decreases. The first look finds the
/// instrument at rest. With a sampling interval sample k is what the true value gave at k ·
/// interval (linear between looks) with the k-th normal number, however often it is looked at;
/// without, each look is a sample. `stream` tells channels apart. Pre-condition: a finite value.
TransducerReading look(const Transducer& transducer, TransducerState& state, double true_si,
                       double time_s, std::uint64_t seed, std::uint64_t stream);

/// One look at rest with that standard normal number, at time 0.
TransducerReading read(const Transducer& transducer, double true_si, double normal);

}  // namespace triax::lab

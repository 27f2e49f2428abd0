// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/devices/fault.hpp"
#include "lab/devices/transducer.hpp"

namespace triax::lab {

/// What comes out of a channel under its faults, in the order in which they lie on the way from the
/// instrument to the record:
///   drift         size · (t − from) is added
///   spike         one reading in each 32 is off by +size or −size
///   open circuit  the positive end of the range
///   latency       what there was `size` seconds ago (the longest of those active)
///   stuck         the last value that came out before it
///   drop-out      nothing: NaN
/// Drifted and spiked readings keep to the converter's step and range. Without a fault a reading
/// passes to the bit. It can be copied and does not grow.
class FaultyChannel {
 public:
  /// Readings that are kept for latency. A delay of more calls than that is kept to 1/60 of it.
  static constexpr std::size_t kKept = 64;

  /// What it remembers; plain values.
  struct State {
    struct Kept {
      double time_s = 0, si = 0;
      bool operator==(const Kept&) const = default;
    };
    std::uint64_t passed = 0;             ///< readings so far
    std::optional<double> last_given_si;  ///< the last one that was none of stuck and dropped
    std::array<Kept, kKept> ring{};
    std::size_t kept = 0, next = 0;
    bool saturated = false;
    bool operator==(const State&) const = default;
  };

  /// All `faults` are those of this channel. An open circuit needs a transducer with a range;
  /// without one it gives no readings (NaN). `seed` and `stream` as for look(): spikes are
  /// independent of the noise.
  FaultyChannel(std::vector<Fault> faults, const Transducer& transducer, std::uint64_t seed,
                std::uint64_t stream);

  /// Other faults of this channel from now on; what it remembers stays.
  void set_faults(std::vector<Fault> faults);
  /// The next reading; `time_s` never decreases. Pre-condition: a finite value.
  double pass(double si, double time_s);
  /// Whether the last reading was at an end of the range.
  bool saturated() const { return state_.saturated; }
  const State& state() const { return state_; }

 private:
  double disturbed(double si, double time_s) const;
  double spike_of(const Fault& fault) const;
  void keep(double si, double time_s);
  double as_of(double time_s) const;

  std::vector<Fault> faults_;
  sim::Unit unit_;
  double step_ = 0;  ///< of readings; 0 where a polynomial bends them
  double lowest_si_ = 0, highest_si_ = 0;
  std::uint64_t seed_ = 0, stream_ = 0;
  double longest_latency_s_ = 0;
  State state_;
};

}  // namespace triax::lab

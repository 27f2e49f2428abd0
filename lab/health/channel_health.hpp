// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "lab/health/channel_noise.hpp"
#include "lab/health/sensor_finding.hpp"
#include "lab/health/sensor_limits.hpp"

namespace triax::lab {

/// By how many times a channel may rest longer than others before it is stuck: a controller may
/// hold its pressure, and a piston its place, quieter than the noise so far.
double patience_of(Quantity quantity);

/// Differences below this are round-off of somebody's arithmetic: no instrument resolves them. SI
double finest_of(Quantity quantity);

/// A change below this is worth no word while little is known of the channel's noise. SI: the drift
/// of a raw channel, 1 kPa of another pressure, 0.02 % of a strain.
double worth_of(Quantity quantity);

/// Checks one channel, one reading at a time, in constant memory, and finds from which reading to
/// which it is faulty (SensorFault), by sensor_limits.hpp. A reading is in doubt until it is
/// decided: after at most sensor_limits::kMaxRun readings.
class ChannelHealth {
 public:
  static constexpr int kAfterStart = 4;  ///< values that show whether the first one was none

  struct Dead {
    SensorFault fault{};
    std::int64_t from = 0;
  };
  /// Readings that leave the level before and after them, which is the same.
  struct Spike {
    std::int64_t from = 0, until = 0;
    double value = 0;
    /// By so much that it needs no look at other channels. Otherwise it is a spike only if no other
    /// channel leaped at the reading `leap`: a specimen that is loaded and unloaded moves several.
    bool certain = true;
    std::int64_t leap = 0;
  };

  /// For `finest` see ChannelNoise; `patience` stretches the wait for a stuck channel: a controlled
  /// quantity may rightly rest. For `worth` see worth_of. `printed_as_set`: the channel may be what
  /// a controller was set to, without noise, so that only a rest after a jump of more than `worth`
  /// is a fault.
  explicit ChannelHealth(double finest, double patience = 1, double worth = 0,
                         bool printed_as_set = false)
      : patience_(patience), worth_(worth), printed_as_set_(printed_as_set), noise_(finest) {}

  /// Whether the channel may rightly stand still from now on, however noisy it was: then the noise
  /// is no ground to call it stuck.
  void may_rest(bool yes);

  /// The value of reading `number`; NaN where there is none.
  void add(std::int64_t number, double value);

  /// Why the channel cannot be believed now, if so.
  const std::optional<Dead>& dead() const { return dead_; }
  /// A channel that is read regularly was not read this time.
  bool absent() const { return gap_ > 0 && steady_ >= sensor_limits::kRegular.count(); }
  /// The spike that this reading brought to light.
  const std::optional<Spike>& spike() const { return spike_; }
  /// The record ends with this reading: a channel that leaped to exactly zero, or to one value
  /// beyond all before, and is still there dropped out, as far as it tells. Result as spike().
  void finish(std::int64_t last);
  /// Whether the channel leaped at this reading, one of the last 64.
  bool leaped_at(std::int64_t number) const;
  /// First reading that may still turn out to be wrong; none is before it. kNever where none may
  /// (no optional: its copy would wait for its own stores, a twentieth of a replay).
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  std::int64_t doubtful_from() const {
    const bool quiet = gap_ == 0 && noise_.run() == 0 && !leap_ && !jump_ && !starts_;
    return quiet ? kNever : first_doubt();
  }

  // For what only a look at other channels can decide:
  /// Readings since the channel last moved, and the first of those that repeat its value.
  std::int64_t run() const { return noise_.run(); }
  std::int64_t run_from() const { return run_from_; }
  /// The first reading of the present value, where a jump led to it.
  std::optional<std::int64_t> jumped_at() const { return jump_; }
  double jump_height() const { return jump_height_; }
  double value() const { return last_; }
  const ChannelNoise& noise() const { return noise_; }
  /// Declares the channel dead from the start of the run; from the jump, where one led to it, and
  /// from a leap just before that, which may have been a spike.
  void condemn();

 private:
  std::int64_t first_doubt() const;
  void miss(std::int64_t number);
  std::optional<std::int64_t> last_leap() const;
  void follow_run(std::int64_t number, double value);
  void follow_jump(std::int64_t number, double value);
  void forget_leap();
  void begin_leap(std::int64_t number, double height, double allowed, bool known);
  bool is_flat_since_leap(std::int64_t number) const;
  void look_for_spike();
  void look_for_flat();
  void look_for_start();
  bool revived(bool moved);

  static constexpr int kWindow = 2 + sensor_limits::kSpike.count() + 2;
  struct Value {
    std::int64_t number = 0;
    double value = 0;
  };
  /// The level beside a possible spike: two values before it and two after it.
  struct Level {
    double before2, before1, after1, after2;
  };
  /// By how many times what the level itself moves the values leave it; 0: not by allowed_.
  double leaves(const Level& level, int width, double first, double last) const;

  /// Whether the channel may rest as it does now.
  bool may_be_at_rest() const {
    return may_rest_ || (printed_as_set_ && !(jump_ && jump_height_ > worth_));
  }

  double patience_, worth_;
  bool printed_as_set_;
  bool may_rest_ = false;
  ChannelNoise noise_;
  std::array<Value, kWindow> window_{};  ///< the last values, oldest first
  int filled_ = 0;
  std::int64_t run_from_ = 0;
  std::optional<std::int64_t> jump_;  ///< reading of a jump from which the value has not moved
  std::int64_t jump_begin_ = 0;       ///< or of a leap just before, from which it did not come back
  std::optional<std::int64_t> leap_;  ///< reading that may begin a spike
  double allowed_ = 0;                ///< what is no leap, as it was known before leap_
  bool certain_ = true;               ///< allowed_ rests on enough moves
  double before1_ = 0, before2_ = 0;  ///< the last two values before leap_
  double lowest_ = 0, highest_ = 0;   ///< before leap_
  double leap_height_ = 0;
  Value start_;                   ///< the first value
  bool starts_ = false;           ///< whether start_ is still in doubt
  std::int64_t start_until_ = 0;  ///< its last repetition
  int after_start_ = 0;           ///< values since then, the first three, and their range
  std::array<double, 3> next_{};
  double low_after_ = 0, high_after_ = 0;
  std::optional<std::int64_t> back_;  ///< reading at which one value since leap_ ended
  std::uint64_t leaps_ = 0;           ///< of the last 64 readings, the latest in bit 0
  std::int64_t latest_ = 0;           ///< number of the latest reading
  double jump_height_ = 0;
  double last_ = 0;
  std::int64_t gap_ = 0, gap_from_ = 0, steady_ = 0;
  int moves_ = 0;  ///< since the channel died
  std::optional<Dead> dead_;
  std::optional<Spike> spike_;
};

}  // namespace triax::lab

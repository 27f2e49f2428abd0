// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All sensors of a test, each by itself and against the others.
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "lab/health/channel_health.hpp"
#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// One bit a quantity.
using ChannelSet = std::uint32_t;
constexpr ChannelSet channel_bit(Quantity q) { return ChannelSet{1} << index(q); }

/// Beside what ChannelHealth sees in one channel (raw records only), by sensor_limits.hpp:
/// - in shear driven by displacement, the force stands still to the last digit though the area grew
///   so much that it cannot: F Δε of kSteps steps of its converter;
/// - in shear driven by displacement, the displacement stands still though the load changed by more
///   than the stiffest soil takes up within kMinSteps steps of the converter; or it stands still
///   kVeryLongRest times as long as ever before in the stage and the load grows by kGainOfLoad,
///   where a frame that has stopped would see it relax;
/// - in drained shear, the volume stands still kLongRest times as long as ever before while p′
///   changes by kChangeOfP, by more than noise, and by more than the stiffest soil takes up within
///   kMinSteps steps: at a turn of the volume it rests three times as long as just before, and
///   where it has come to rest for good, so has p′; or it moved before shear and in shear not once,
///   while p′ changes by kLargeChangeOfP; or, under a load or a held q, while the axial
///   strain grows by kRunningStrain: nothing shears like that at constant volume. Along a strain
///   path, dε_v = (1 − 1/R) dε₁, only where more than kSteps steps of flow were prescribed, and not
///   at all where that is next to nothing (kPathFlow);
/// - in shear, the pore pressure (driven by displacement, force and displacement too) jumps alone
///   and then stands still to the last digit; at any time the volume, by kVolumeJump of the
///   specimen's. With the valve closed, or by kImpossibleJump, it need not be alone.
class RecordHealth {
 public:
  /// Readings after which a channel at rest is no longer doubted by what others do.
  static constexpr std::int64_t kLongestRest = 900;

  /// Readings from..until of a channel turned out to be wrong.
  struct Wrong {
    SensorFinding finding;
    std::int64_t from = 0, until = 0;
  };

  explicit RecordHealth(const RecordHeader& header);

  void watch(const Reading& reading);
  /// No more readings will come: what only shows by that. Results as of watch().
  void finish();
  /// What the last reading brought to light about itself and readings before it.
  const std::vector<Wrong>& wrong() const { return wrong_; }
  /// First reading about which something may still come to light: no earlier one can be found
  /// wrong.
  std::int64_t doubtful_from() const { return doubtful_from_; }
  /// Findings that came to light with the last reading.
  const std::vector<SensorFinding>& news() const { return news_; }
  /// One sentence for each sensor and kind of fault.
  std::vector<Warning> warnings() const;

 private:
  using RawValues = std::array<double, kRawQuantityCount>;
  struct Channel {
    Quantity quantity{};
    ChannelHealth health;
    std::optional<SensorFinding> open;          ///< what it is dead of
    std::optional<std::int64_t> lonely_jump{};  ///< reading at which it jumped and no other did
    bool stirred = false;                       ///< out of a rest, by this reading
    std::int64_t moves = 0, longest_run = 0;    ///< in drained shear
    RawValues at_rest{};                        ///< all channels where it came to rest
  };
  struct Tally {
    SensorFinding first;
    std::int64_t more = 0;
  };
  void start_stage(const Reading& reading);
  void compare(Channel& channel, const Reading& reading);
  bool is_compared(Quantity q) const;
  /// Readings since the channel last moved, or since the stage began.
  std::int64_t rest(const Channel& channel, const Reading& reading) const;
  /// These can be held against another.
  bool sound(std::initializer_list<Quantity> quantities) const;
  bool runs_away(const Channel& channel, const Reading& reading) const;
  bool cannot_rest(const Channel& channel, const Reading& reading) const;
  bool outlasts(const Channel& channel, const Reading& reading) const;
  bool never_moves(const Channel& channel, const Reading& reading) const;
  bool loads_up(const Channel& channel, const Reading& reading) const;
  double noise_of(Quantity quantity) const;
  double p_noise() const;
  double p_eff(const RawValues& values) const;
  bool jumped(const Channel& channel) const;
  void note_jumps(const Reading& reading);
  bool water_is_shut_in(const Channel& channel) const;
  bool is_held_through_valve(const Channel& channel) const;
  void note_fall(const Reading& reading);
  void report(Channel& channel, const Reading& reading);
  void report_spike(const Channel& channel);
  SensorFinding& tally(const SensorFinding& finding);
  std::optional<double> time_of(std::int64_t number) const;

  RecordHeader header_;
  const bool raw_;                      ///< header_.is_raw()
  double area_m2_ = 0, volume_m3_ = 0;  ///< as built; 0: unknown
  std::vector<Channel> channels_;
  std::optional<int> stage_;
  std::int64_t stage_from_ = 0, latest_ = -1;  ///< readings
  bool shear_ = false, driven_ = false, drained_ = false, closed_ = false, open_ = false;
  bool held_ = false;
  std::optional<double> path_flow_;  ///< |dε_v/dε₁| that the stage prescribes
  bool fell_ = false;  ///< in this stage, by assessment_limits::kLeap from one reading to the next
  double displacement_ = NAN;                  ///< axial, at the last reading
  static constexpr std::size_t kTimes = 1024;  ///< more than any hindsight
  std::array<double, kTimes> times_{};         ///< of the last readings
  RawValues now_{};
  std::vector<Wrong> wrong_;
  std::vector<SensorFinding> news_;
  std::int64_t doubtful_from_ = 0;
  std::vector<Tally> tallies_;  ///< one a channel and kind
};

}  // namespace triax::lab

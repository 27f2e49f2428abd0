// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>

namespace triax::lab {

/// What the past of one channel says about its noise, in constant memory: exponential means over
/// the last kMemory readings.
///
/// The values of a live converter differ from their neighbours by noise. Let f be the share of
/// neighbours that are equal; n equal neighbours in a row then have a probability of about fⁿ, and
/// beyond n = ln(kChance)/ln f (sensor_limits.hpp) they are no noise. That holds only where it is
/// noise that moves the values. A ramp without noise moves them too, and may rightly end at rest:
/// it differs from noise by never turning back, and by a roughness of no more than one step of the
/// converter. A channel that flickers between two neighbouring values has so little noise that it
/// rests as soon as its mean lies between two flips: it does not dither either.
class ChannelNoise {
 public:
  static constexpr int kMemory = 256;
  static constexpr int kLeast = 40;  ///< neighbours from which anything is said

  /// Differences of `finest` and less are round-off, not readings.
  explicit ChannelNoise(double finest) : finest_(finest) {}

  /// The next value of a live channel (no NaN).
  void add(double value);
  /// The last value again and again: forget that it was seen `run` times, it was no noise.
  void forget_run() { run_ = 0; }
  /// Equal neighbours at the end of what was added.
  std::int64_t run() const { return run_; }

  /// Mean |x − (x₋ + x₊)/2| where the value moved, robust against outliers; 0 before there are
  /// three values.
  double roughness() const { return roughness_; }
  /// Smallest first or second difference, the step of the converter or less; 0 if none is known.
  double step() const { return step_; }
  /// The least difference that a reading can mean.
  double resolution() const;
  /// Neighbours that differed.
  std::int64_t moves() const { return moves_; }
  std::int64_t values() const { return values_; }
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  /// Whether noise is what moves the values.
  bool dithers() const;
  /// Equal neighbours that noise cannot give; empty where the channel does not dither, or does it
  /// so little that the wait would be longer than sensor_limits::kMaxRun.
  const std::optional<std::int64_t>& impossible_run() const { return wait_; }

  static constexpr std::int64_t kLessons = 16;  ///< between two looks at what was learned

 private:
  void end_run();
  std::optional<std::int64_t> wait() const;
  void add_roughness(double half_bend);
  double equal_share_at_most() const;

  double round_off() const;

  double finest_;
  std::int64_t values_ = 0, neighbours_ = 0, bends_ = 0, run_ = 0;
  double last_ = 0, before_ = 0;
  double last_move_ = 0, last_bend_ = 0;
  double equal_ = 0;       ///< share of equal neighbours
  double moves_back_ = 0;  ///< share of moves that turn back
  double wide_moves_ = 0;  ///< share of moves by more than a step
  double bends_back_ = 0;  ///< share of second differences that alternate
  std::int64_t moves_ = 0;
  double roughness_ = 0, step_ = 0;
  double longest_run_ = 0;            ///< fades
  std::optional<std::int64_t> wait_;  ///< as of the last of every kLessons neighbours
  double lowest_ = 0, highest_ = 0, largest_ = 0;
};

}  // namespace triax::lab

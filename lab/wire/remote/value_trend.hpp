// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Predicts the next value of one channel from the values accepted so far.
//
// Let x be the last accepted value, Δ its change per scan and n the scans since. The next value is
// expected between x (nothing changes any more) and x + nΔ (it goes on as before). off(v) is the
// distance of v from that interval, and the tolerance
//     t = max(kFactor · r, kDigits · |x|)
// follows from r, the third largest off() of the last kWindow accepted values. One step of a value
// leaves two large distances and does not widen the tolerance. White noise of standard deviation σ
// gives t ≈ 6 σ and an unexpected value in one of 2,000. All numbers have the unit of the channel.
#include <array>
#include <cstddef>
#include <optional>

namespace triax::lab {

class ValueTrend {
 public:
  static constexpr std::size_t kWindow = 64, kRank = 3;
  static constexpr double kFactor = 2;
  static constexpr double kDigits = 1e-9;  ///< round-off of a printed number, relative
  static constexpr int kMaxScans = 4;      ///< n beyond which no value is expected

  /// Whether the value needs no confirmation.
  bool expects(double value) const;
  /// Whether two replies in a row agree: |v − v₀| ≤ max(t, off(v)/2). A value that changes fast is
  /// nearer to the one before than to what was expected. ±infinity agrees with itself.
  bool confirms(double value, double before) const;
  /// Begins with a value and its noise: a distance that other values had from it.
  void start(double value, double noise);
  /// The value of this scan, finite or ±infinity (the end of the instrument's range).
  void accept(double value);
  /// This scan has no value.
  void miss() { ++scans_; }
  /// The last accepted finite value; empty: none yet.
  const std::optional<double>& value() const { return value_; }

 private:
  double off(double value) const;
  double tolerance() const;

  std::optional<double> value_;
  double change_ = 0;  ///< Δ
  double at_end_ = 0;  ///< ±infinity while the instrument is at the end of its range
  int scans_ = 1;      ///< n
  std::array<double, kWindow> offs_{};
  std::size_t count_ = 0;  ///< of offs_ so far
};

}  // namespace triax::lab

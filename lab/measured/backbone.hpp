// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Strength lost from reading to reading, for records with too few of them for windows.
#include <array>
#include <cstdint>
#include <optional>

#include "lab/results/state.hpp"

namespace triax::lab {

/// Strength lost along the backbone of a path: its states at which the axial strain, in the
/// direction of shear, is larger than ever before. What unloads, reloads or relaxes is not among
/// them, and where the path comes back from an unloading it begins anew, with the strength that the
/// loop left: a loss along it is one of monotonic shear.
struct BackboneFall {
  State peak;                 ///< largest |q| before the fall
  State last_high;            ///< last state that had nearly all of it
  State least;                ///< smallest |q| since
  double regained = 0;        ///< largest |q| since that, Pa
  std::int64_t readings = 0;  ///< from last_high to the first that had lost kWorth
  bool confirmed = false;     ///< by a second state without it, or by a leap of the strain
  bool drained = false;       ///< lost with the drainage open and the axis moved by displacement

  double loss() const;            ///< share of the peak, 0 to 1
  double share_regained() const;  ///< of what was lost
  /// Of the increment from last_high to least, Eq. (23); no noise enters that a table would tell.
  double normalised_work() const;
};

/// Follows compression and extension each by itself, in constant memory.
class Backbone {
 public:
  static constexpr double kHigh = 0.98;         ///< of the peak: nearly all of it
  static constexpr double kWorth = 0.10;        ///< as Descent::kWorthALoss
  static constexpr double kLeastStrain = 5e-4;  ///< of the fall: else the drive stands
  static constexpr double kLeastRatio = 0.05;   ///< |q|/p′ of a peak that is one
  static constexpr double kNoises = 10;         ///< of q from state to state
  static constexpr std::int64_t kFew =
      32;  ///< readings: a fall within them is over before windows tell

  void start_stage(bool drained) { drained_ = drained; }
  void add(const State& state);
  /// The fall that cost most, of those that cost kWorth or more.
  std::optional<BackboneFall> worst() const;

 private:
  struct Side {
    double sign = 1;
    double farthest = 0;  ///< axial strain in this direction
    bool any = false;
    bool turned = false;  ///< unloaded since
    BackboneFall fall{};  ///< under way; its peak stands before any
    std::optional<BackboneFall> worst{};
    double noise = 0;  ///< of q from state to state, before the fall
    int noises = 0;
    double strength(const State& s) const { return sign * s.q; }
    void add(const State& state, double way, bool drained);
    void begin(const State& state);
    void descend(const State& state, bool drained);
    bool counts() const;
    std::optional<BackboneFall> larger() const;
  };
  void learn_noise(double q);

  bool drained_ = false;
  std::optional<double> origin_;
  std::array<Side, 2> sides_{Side{.sign = 1}, Side{.sign = -1}};
  std::array<double, 2> q_before_{};
  double bend_before_ = 0;
  int seen_ = 0;
};

}  // namespace triax::lab

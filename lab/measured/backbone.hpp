// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Strength lost from reading to reading, for records with too few of them for windows.
#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "lab/measured/bend_noise.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// A loss of strength along the backbone. Stresses in Pa.
struct BackboneFall {
  State before_peak;          ///< the one before that: the peak may lie between the two
  State peak;                 ///< largest |q| before the fall
  State last_high;            ///< last state that had nearly all of it
  State first_low;            ///< first that had lost it
  State least;                ///< smallest |q| since
  double regained = 0;        ///< largest |q| since that
  std::int64_t readings = 0;  ///< from last_high to the first that had lost it
  bool confirmed = false;     ///< by a second state in a row without it, or by a leap of the strain
  double noise = 0;           ///< of |q| before it, see BendNoise
  std::optional<Moment> noticed;  ///< when it was confirmed; empty: it was not before the end
  bool drained = false;  ///< lost with the drainage open and the axis moved by displacement
  /// The axial strain went on while the strength was gone: by kMinStrain, or at kMinPace of its
  /// increase per reading before the fall. Otherwise the drive had stopped.
  bool axis_went_on = false;

  double loss() const;            ///< share of the peak; above 1 where q changed its sign
  double share_regained() const;  ///< of what was lost
  /// Of the increment from last_high to least, Eq. (23); no noise enters that a table would tell.
  double normalised_work() const;
};

/// The backbone of a path: its states at which the axial strain, in the direction of shear, is
/// larger than ever before. What unloads, reloads or relaxes is not among them, and where the path
/// comes back from an unloading it begins anew, with the strength that the loop left: a loss along
/// it is one of monotonic shear. Compression and extension each by itself, in constant memory.
///
/// A fall counts if |q| lost kLossOfStrength of the peak and kNoise times its noise
/// (assessment_limits.hpp) within kFew readings
/// (windows assess slower ones), the axis went on while the strength was gone, and second-order
/// work is negative.
class Backbone {
 public:
  static constexpr double kMinStrain = 5e-4, kMinPace = 0.5;  ///< BackboneFall::axis_went_on
  static constexpr std::int64_t kFew = 32;                    ///< readings

  void start_stage(bool drained);
  /// What is confirmed by this state is known at the reading `now`.
  void add(const State& state, const std::optional<Moment>& now = {});
  /// The fall that cost most.
  std::optional<BackboneFall> worst() const;

 private:
  struct Side {
    double sign = 1;
    double front = 0;            ///< largest axial strain in this direction
    double farthest = 0;         ///< that of the last state of the backbone
    double largest_step = 0;     ///< of the strain, between two of them
    std::deque<State> recent{};  ///< of the last kFew readings
    BendNoise noise{};           ///< of |q| along it
    bool any = false;
    bool turned = false;  ///< unloaded since
    BackboneFall fall{};  ///< under way; its peak stands before any
    std::optional<BackboneFall> worst{};
    double pace = 0;  ///< increase of the strain per reading, before the fall
    double strength(const State& s) const { return sign * s.q; }
    double strain(const State& s) const { return sign * s.strain.axial; }
    void add(const State& state, double way, bool drained);
    void forget(const State& state);
    void begin(const State& state);
    bool gone(const State& state) const;
    void note_low(const State& state);
    double pace_of_recent() const;
    void descend(const State& state, double step, bool drained);
    bool counts() const;
    std::optional<BackboneFall> larger() const;
  };

  bool drained_ = false, new_stage_ = false;
  std::optional<State> first_, last_;
  std::array<Side, 2> sides_{Side{.sign = 1}, Side{.sign = -1}};
};

}  // namespace triax::lab

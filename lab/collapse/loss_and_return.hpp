// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a runaway took from a specimen, and what of it came back.
#include <optional>

#include "lab/measured/bend_noise.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Follows |q| from the reading before a runaway on. What was lost is the fall to the smallest |q|
/// of the stage in which the specimen ran; what came back is how far |q| grew again since, in that
/// stage or a later one, at two readings in a row: one alone is a spike of the load cell. Where it
/// comes back the loss was a limited one, however large: a jump to a new equilibrium, beyond which
/// the specimen hardens.
///
/// A later stage tells of the same specimen only while that is not made another: nothing comes back
/// any more once it is consolidated, once water may flow that was shut in when it ran, and, where
/// water could flow, once σ₃′ grows by more than a tenth.
class LossAndReturn {
 public:
  /// `before`: the last reading before the runaway; `leap` of the axial strain: in cycles a
  /// specimen runs into compression while q is still on the other side of zero, and becomes strong
  /// there.
  LossAndReturn(const State& before, double leap, Drainage drainage);
  void start_stage(const StageInfo* stage);
  /// Every later state; passed over while q is not known.
  void add(const State& state);

  /// Of |q| before, 0 to 1.
  double lost() const;
  /// Likewise; more than lost() where the specimen became stronger than it was.
  double regained() const;
  bool came_back() const;
  /// Smallest |q| and the largest since, Pa.
  double least() const { return least_; }
  double largest_since() const { return most_; }

 private:
  double strength(const State& state) const;

  double before_ = 0, radial_ = 0, least_ = 0, most_ = 0;
  double last_ = 0;  ///< at the last state
  double sign_ = 1;
  BendNoise noise_;
  Drainage drainage_ = Drainage::unknown;
  bool stage_over_ = false, another_specimen_ = false;
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What no specimen can do: the unit, a zero or a dimension is wrong, and nothing is judged on it.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Looks at the specimen and at the states of shear, in constant memory.
///   impossible   q/p' above kSteepest or below −1.5, where σ₃' or σ₁' would be next to zero or
///                below, while p' is worth looking at (kWorth of that at the start); p'₀ outside
///                0.5 kPa to 60 MPa, or later stresses beyond twice that, of which tests are made:
///                pressures in another unit also a specimen flatter than kFlattest or slimmer than
///                kSlimmest
///   idle         |q| within 1 % of p'₀ all through, over 1 % of axial strain and more: the force
///                is in another unit, or was not recorded
///   backwards    |q| grew, always on one side, while the axial strain went the other way: the
///                sign of one of the two is not what its column says
///   slipped      from the largest axial strain on |q| only fell, to half of it, at no smaller a
///                stress ratio: a specimen that is unloaded keeps p' and loses q/p'; this one
///                collapsed, and its strain was measured elsewhere
///   to be told   q below −5 kPa and −2 % of p'₀ where compression begins (a load cell that was not
///                set to zero); σ₃' below zero; a mobilised friction angle above 60°
class Plausibility {
 public:
  static constexpr double kSteepest = 2.6;                 ///< q/p' of 65 degrees
  static constexpr double kFlattest = 0.5, kSlimmest = 4;  ///< height over diameter
  static constexpr double kWorth = 0.1;
  static constexpr double kLeastStress = 500, kMostStress = 60e6;  ///< Pa

  explicit Plausibility(SpecimenInfo specimen) : specimen_(std::move(specimen)) {}

  /// The next state of shear; false where no specimen can have been in it.
  bool add(const State& state);
  /// Why not; of the first one.
  const std::string& impossible() const { return impossible_; }
  /// Why nothing of what was seen can be judged; empty: it can.
  std::string idle() const;
  std::string backwards() const;
  /// Beyond which reading nothing can be judged, and why.
  struct Slip {
    std::int64_t last = 0;
    std::string reason;
  };
  const std::optional<Slip>& slip() const { return slip_; }
  std::vector<Warning> warnings() const;

 private:
  std::string impossible_in(const State& state) const;
  void watch_fall(const State& state);

  SpecimenInfo specimen_;
  std::optional<State> first_;
  double largest_q_ = 0, largest_strain_ = 0;
  double least_q_ = 0, most_q_ = 0;                ///< with their signs
  double lowest_strain_ = 0, highest_strain_ = 0;  ///< from the first
  double strain_at_largest_ = 0;                   ///< of |q|
  std::optional<State> furthest_;                  ///< at the largest q or the largest strain
  double least_since_ = 0;                         ///< |q|, since then
  std::optional<Slip> slip_;
  std::string impossible_;
  std::optional<State> tension_, steep_;  ///< the first with σ₃' below zero, and above 60°
};

}  // namespace triax::lab

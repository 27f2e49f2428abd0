// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What no specimen can do: the unit, a zero or a dimension is wrong, and nothing is judged on it.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/collapse/limit_surface.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Decides whether a state is possible, and looks at the specimen and at the states of shear as a
/// whole, in constant memory, by sensor_limits.hpp.
///   specimen     flatter than kFlattest or slimmer than kSlimmest: nothing can be judged
///   impossible   a state beyond the limit surface of any soil and the error of the sensors,
///                q > kSteepest (p' + e) or −q > kSteepestExtension (p' + e), so that p' and σ₃'
///                below −e are always impossible; e = zero_error(p'₀). With cohesion, which the
///                specimen's description gives, only those (3 and 1.5). Also stresses beyond twice
///                60 MPa, kMaxStressOfRock with cohesion; and, before the first possible state, a
///                p' outside 0.5 kPa to 60 MPa, of which tests are made: a logger's code, a sensor
///                that dropped out, or a pressure in another unit
///   idle         |q| within 1 % of p'₀ all through, over 1 % of axial strain and more: the force
///                is in another unit, or was not recorded
///   backwards    |q| grew, always on one side, while the axial strain went the other way: the
///                sign of one of the two is not what its column says
///   slipped      from the largest axial strain on |q| only fell, to half of it, at no smaller a
///                stress ratio: a specimen that is unloaded keeps p' and loses q/p'; this one
///                collapsed, and its strain was measured elsewhere
///   reported     q below −5 kPa and −2 % of p'₀ where compression begins, or as much above zero if
///                it was not applied during consolidation (a load cell that was not set to zero),
///                σ₃' below zero, a mobilised friction angle above that of any soil without
///                cohesion (assessment_limits::kSteepest)
class Plausibility {
 public:
  /// `begins_unloaded`: q is that of a measured force, and no type of test states an anisotropic
  /// consolidation.
  explicit Plausibility(SpecimenInfo specimen, bool begins_unloaded = false)
      : specimen_(std::move(specimen)), limit_(specimen_), begins_unloaded_(begins_unloaded) {}

  /// Pa: what zeros of load cell and pressure transducers may be off by, together: 2 % of p'₀ and
  /// at least 5 kPa, but no more than 10 % of p'₀.
  static double zero_error(double p_eff_start);

  /// Whether a specimen of any soil can be in this state. p'₀ is that of the first possible state
  /// that was added; before there is one, that of `state`.
  bool is_possible(const State& state) const;
  /// Why is_possible() is false; empty if it is true.
  std::string impossible(const State& state) const;
  /// Why no specimen of these dimensions can be tested; empty if it can.
  std::string impossible_specimen() const;

  /// q of a state of consolidation.
  void add_consolidation(double q);
  /// The next state of shear; false if it is impossible. Such a state counts for nothing else.
  bool add(const State& state);
  /// How many impossible states were added.
  std::int64_t impossible_count() const { return impossible_count_; }
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
  void watch_fall(const State& state);
  bool exceeds_any_cell(const State& state) const;
  /// p' and its error.
  double reach(const State& state) const;
  std::string steep_words() const;
  std::string start_load_words() const;

  SpecimenInfo specimen_;
  LimitSurface limit_;  ///< of that cohesion
  bool begins_unloaded_;
  std::optional<double> q_before_;  ///< at the start of consolidation
  std::optional<State> first_;
  double largest_q_ = 0, largest_strain_ = 0;
  double least_q_ = 0, most_q_ = 0;                ///< with their signs
  double lowest_strain_ = 0, highest_strain_ = 0;  ///< from the first
  double strain_at_largest_ = 0;                   ///< of |q|
  std::optional<State> furthest_;                  ///< at the largest q or the largest strain
  double least_since_ = 0;                         ///< |q|, since then
  std::optional<Slip> slip_;
  std::string impossible_;  ///< why the first impossible state is
  std::int64_t impossible_count_ = 0, last_impossible_ = -1;
  std::optional<State> tension_, steep_;  ///< the first with σ₃' below zero, and too steep
};

}  // namespace triax::lab
